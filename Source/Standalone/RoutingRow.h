#pragma once

#include "AudioHost.h"
#include "LevelBar.h"

#include <juce_gui_basics/juce_gui_basics.h>

namespace antinode
{
/** One ceramic: its output, the amplifier behind it, its identify tone, its level. */
class RoutingRow final : public juce::Component
{
public:
    /** @param hostToUse  outlives this @param ceramicToShow  from 0 @param outputs  to choose from [message thread] */
    RoutingRow (AudioHost& hostToUse, int ceramicToShow, int outputs);

    /** Shows what the host's routing says. [message thread] */
    void update();

    /** Shows levels and the tone; a few times a second. [message thread] */
    void updateLevel();

    void lookAndFeelChanged() override;
    void resized() override;

    /** The headings of the columns in the colour that is set, above rows of the same width. [message thread] */
    static void paintHeadings (juce::Graphics&, juce::Rectangle<int>);

private:
    int output() const { return host.settings().routing.outputs[static_cast<std::size_t> (ceramic)]; }
    void changeChain();

    AudioHost& host;
    int ceramic;
    std::int64_t clampedBefore = 0; ///< Samples of its output, when it was last another one's.
    int clampedOutput = OutputRouting::none;
    juce::Label name;
    juce::ComboBox outputChoice;
    juce::TextEditor volts;
    juce::TextButton polarity, identify { "Identify" };
    LevelBar level;
};
} // namespace antinode
