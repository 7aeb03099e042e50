#pragma once

#include "DesignPicture.h"

#include <Plugin/AntinodeProcessor.h>

#include <memory>

namespace antinode
{
/** One sentence: what is being worked out, or what is wrong. [message thread] */
class StatusLine final : public juce::Component, public juce::SettableTooltipClient
{
public:
    explicit StatusLine (AntinodeProcessor&);

    /** @param picture    the newest one, or none
        @param isWorking  whether a newer one is being worked out */
    void refresh (const DesignPicture* picture, bool isWorking);

    /** Says something once, until it is said otherwise: what a click could not do. */
    void say (const juce::String& sentence);

    juce::String text() const { return shown; }

    void paint (juce::Graphics&) override;

private:
    struct Message
    {
        juce::String text;
        bool isWarning = false;
    };

    Message message (const DesignPicture* picture, bool isWorking) const;

    AntinodeProcessor& processor;
    juce::String said, shown, figures;
    bool isWarning = false;
};
} // namespace antinode
