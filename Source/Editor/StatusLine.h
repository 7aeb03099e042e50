#pragma once

#include <antinode_session/UserMessages.h>

#include <juce_gui_basics/juce_gui_basics.h>

#include <functional>
#include <vector>

namespace antinode
{
/** The messages of a window, the worst first, one below the other: as high as they need. [message thread] */
class StatusLine final : public juce::Component, public juce::SettableTooltipClient
{
public:
    StatusLine();

    /** @param present  in any order, those whose cause lasts
        @param figures  what stands at the right
        @param seconds  since the last call */
    void show (std::vector<UserMessage> present, const juce::String& figures, double seconds);

    /** Shows a sentence for some seconds, or until the next one, for example why a click had no effect. */
    void say (const juce::String& sentence);

    /** The worst message. */
    juce::String text() const;
    Urgency urgency() const;

    /** All of them. */
    const std::vector<UserMessage>& messages() const { return shown; }

    /** Pixels that the messages need. */
    int wantedHeight() const;

    /** Called after it has become another one. */
    std::function<void()> onHeight;

    void paint (juce::Graphics&) override;

private:
    std::vector<UserMessage> shown;
    juce::String said, figuresShown;
    double saidFor = 0; ///< s
};
} // namespace antinode
