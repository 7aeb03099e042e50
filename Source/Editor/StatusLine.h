#pragma once

#include "DesignPicture.h"

#include <Processor/AntinodeProcessor.h>

#include <memory>

namespace antinode
{
/** One sentence: what is being worked out, or what is wrong. [message thread] */
class StatusLine final : public juce::Component, public juce::SettableTooltipClient
{
public:
    /** How urgent a sentence is. */
    enum class Level
    {
        calm,
        caution, ///< Something cannot be played, but the focus can.
        warning
    };

    explicit StatusLine (AntinodeProcessor&);

    /** @param picture    the newest one, or none
        @param isWorking  whether a newer one is being worked out */
    void refresh (const DesignPicture* picture, bool isWorking);

    /** Says something once, until it is said otherwise: what a click could not do. */
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
