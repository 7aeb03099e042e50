#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

namespace antinode
{
/** The voltage of a ceramic and the state of its limiter; a click mutes it. [message thread] */
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
    double peakVolts = 0;      ///< The voltage of the hold, V.
    double limitedFor = 0;     ///< s that the lamp stays on.
    int shownPixels = -1;
    bool wasLimited = false;
};
} // namespace antinode
