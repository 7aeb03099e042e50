#pragma once

#include "TouchProcessor.h"
#include <Editor/ParameterControl.h>

#include <juce_gui_basics/juce_gui_basics.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace antinode
{
/** The controls of one finger, and of the output; a row of buttons chooses the finger. [message thread] */
class FingerPanel final : public juce::Component
{
public:
    explicit FingerPanel (TouchParameters&);

    /** Shows the controls of a finger. */
    void select (std::size_t finger);
    std::size_t selected() const { return shown; }

    /** Shows what has changed. */
    void refresh();

    /** Shows all texts again: the device is another one. */
    void refreshTexts (bool isLine);

    /** The height that all controls need. */
    static int height();

    void paint (juce::Graphics&) override;
    void resized() override;
    void lookAndFeelChanged() override;

private:
    static constexpr std::size_t perFinger = 5, ofOutput = 4;

    std::array<juce::TextButton, mostFingers> buttons;
    std::vector<std::unique_ptr<ParameterControl>> fingers; ///< perFinger of each.
    std::vector<std::unique_ptr<ParameterControl>> output;
    std::size_t shown = 0;
};
} // namespace antinode
