#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

namespace antinode
{
/** How much voltage a ceramic gets, whether its limiter acts, and a click that mutes it. [message thread] */
class CeramicMeter : public juce::Button
{
public:
    explicit CeramicMeter (int number);

    /** @param name   of the ceramic
        @param limit  V */
    void setCeramic (const juce::String& name, double limit);

    /** @param volts      the largest since the last call
        @param isLimited  whether samples were clamped since then
        @param seconds    since the last call */
    void refresh (float volts, bool isLimited, double seconds);

    void paintButton (juce::Graphics&, bool isOver, bool isDown) override;

private:
    bool isMuted() const { return getToggleState(); }
    void paintBar (juce::Graphics&, juce::Rectangle<float>) const;

    int channel;
    double limitVolts = 0;
    float level = 0, hold = 0; ///< Of the bar.
    double peakVolts = 0;      ///< What the hold stands for.
    double limitedFor = 0;     ///< s that the lamp stays on.
    int shownPixels = -1;
    bool wasLimited = false;
};
} // namespace antinode
