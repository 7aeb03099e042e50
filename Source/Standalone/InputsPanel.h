#pragma once

#include "LevelBar.h"
#include "TouchHost.h"

#include <juce_gui_basics/juce_gui_basics.h>

#include <array>
#include <utility>

namespace antinode
{
/** The input of the audio device that each finger feels, and its level; and that of the sensor. */
class InputsPanel final : public juce::Component, private juce::Timer
{
public:
    /** @param hostToUse  outlives this [message thread] */
    explicit InputsPanel (TouchHost& hostToUse);

    /** Shows what the host says, and what inputs there are. [message thread] */
    void update();

    void resized() override;

private:
    void timerCallback() override;

    TouchHost& host;
    static constexpr std::size_t sensor = FingerInputs::fingers; ///< Its row is behind those of fingers.

    std::array<juce::Label, sensor + 1> names;
    std::array<juce::ComboBox, sensor + 1> choices;
    std::array<LevelBar, FingerInputs::fingers> levels;
    juce::TextButton straight { "One to one" };
    std::pair<int, int> shownInputs { -1, -1 }; ///< That are listed, and the open ones of them.
};
} // namespace antinode
