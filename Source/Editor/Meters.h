#pragma once

#include "History.h"

#include <antinode_model/ModalModel.h>
#include <antinode_session/InstrumentMeters.h>
#include <juce_gui_basics/juce_gui_basics.h>

#include <array>
#include <memory>
#include <vector>

namespace antinode
{
/** How much of a bar a level fills, 0 to 1. @param lowest  dB from a full bar to an empty one, below 0 [any] */
double levelShare (double value, double full, double lowest);

/** Levels side by side or one below the other: each with a name, a bar that falls slowly, and the largest value of
    late. [message thread] */
class LevelRows final : public juce::Component
{
public:
    /** What a row says. */
    struct Row
    {
        juce::String name, place; ///< "1", "24 mm, 0 mm"; the latter may be empty.
        double full = 1;          ///< The value of a full bar.
    };

    /** @param unit      of the values, "mm/s"
        @param decimals  of the values */
    LevelRows (const juce::String& title, const juce::String& unit, int decimals);

    /** Other rows; those that keep their number keep their levels. */
    void setRows (std::vector<Row>);

    /** Levels and held values begin again: they were another device's. */
    void forget() { levels.assign (rows.size(), {}); }

    /** The ceramics of a device, and their largest voltages since the last call. @param model  none: no rows */
    void showVoltages (const ModalModel*, LevelMeters&, double seconds);

    /** @param values   one a row: the largest magnitudes since the last call
        @param seconds  since the last call */
    void refresh (const std::vector<double>& values, double seconds);

    void paint (juce::Graphics&) override;

private:
    struct Level
    {
        double share = 0, held = 0,
               heldFor = 0; ///< Of the full bar; a value in its unit, and how long it is still shown, s.
    };

    void paintRow (juce::Graphics&, juce::Rectangle<float>, const Row&, const Level&) const;

    juce::String unit;
    int decimals;
    std::vector<Row> rows;
    std::vector<Level> levels;
};

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
