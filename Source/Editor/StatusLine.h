#pragma once

#include "DesignPicture.h"

#include <Processor/AntinodeProcessor.h>

#include <memory>

namespace antinode
{
/** One sentence: the work in progress, or what is wrong. [message thread] */
class StatusLine final : public juce::Component, public juce::SettableTooltipClient
{
public:
    /** The urgency of a sentence. */
    enum class Level
    {
        calm,
        caution, ///< Something other than the focus cannot be played.
        warning
    };

    explicit StatusLine (AntinodeProcessor&);

    /** @param picture    the newest one, or none
        @param isWorking  whether a newer one is being worked out */
    void refresh (const DesignPicture* picture, bool isWorking);

    /** Shows a sentence until the next one, for example why a click had no effect. */
    void say (const juce::String& sentence);

    juce::String text() const { return shown; }
    Level level() const { return shownLevel; }

    void paint (juce::Graphics&) override;

private:
    struct Message
    {
        juce::String text;
        Level level = Level::calm;
    };

    Message message (const DesignPicture* picture, bool isWorking) const;

    AntinodeProcessor& processor;
    juce::String said, shown, figures;
    Level shownLevel = Level::calm;
};
} // namespace antinode
