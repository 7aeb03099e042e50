#pragma once

#include "History.h"

#include <antinode_model/ModalModel.h>
#include <juce_gui_basics/juce_gui_basics.h>

#include <array>
#include <memory>
#include <vector>

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

/** The meters of all ceramics of the device, side by side. [message thread] */
class MetersStrip final : public juce::Component
{
public:
    MetersStrip (AntinodeProcessor&, History&);

    void setModel (const std::shared_ptr<const ModalModel>&);

    /** @param seconds  since the last call */
    void refresh (double seconds);

    void paint (juce::Graphics&) override;
    void resized() override;

private:
    void mute (std::size_t index);

    AntinodeProcessor& processor;
    History& history;
    std::vector<std::unique_ptr<CeramicMeter>> meters;
    std::array<std::int64_t, LevelMeters::ceramics> limited {};
    std::uint64_t shownMutes = 0;
};
} // namespace antinode
