#include "InputsPanel.h"

#include "PanelSizes.h"

#include <Editor/EditorLook.h>

#include <algorithm>

namespace antinode
{
namespace
{
constexpr int fingerNameWidth = 70, inputChoiceWidth = 120, inputMeterMilliseconds = 50;
constexpr int noFingerInput = OutputRouting::maximumOutputs + 1; // identifiers of a choice cannot be 0

int& inputOf (FingerInputs& inputs, std::size_t row)
{
    return row < inputs.inputs.size() ? inputs.inputs[row] : inputs.sensor;
}
} // namespace

InputsPanel::InputsPanel (TouchHost& hostToUse) : host (hostToUse)
{
    for (std::size_t k = 0; k < choices.size(); ++k)
    {
        const auto isSensor = k == sensor;
        names[k].setText (isSensor ? juce::String ("Sensor") : "Finger " + juce::String (k + 1),
                          juce::dontSendNotification);
        names[k].setFont (EditorLook::font (EditorLook::smallTextHeight));
        choices[k].setTooltip (isSensor ? juce::String ("Input of the audio device that following listens to")
                                        : "Input of the audio device that finger " + juce::String (k + 1) + " feels");
        choices[k].onChange = [this, k]
        {
            auto inputs = host.settings().inputs;
            const auto chosen = choices[k].getSelectedId();
            inputOf (inputs, k) = chosen == noFingerInput ? FingerInputs::none : chosen - 1;
            host.setInputs (inputs);
        };

        for (auto* const child : std::initializer_list<juce::Component*> { &names[k], &choices[k] })
            addAndMakeVisible (child);
    }

    for (auto& level : levels)
    {
        level.setTooltip ("Peak of the input, from 60 dB below full scale");
        addAndMakeVisible (level);
    }

    straight.setTooltip ("Gives every finger the input of its number");
    straight.onClick = [this]
    {
        FingerInputs inputs;
        inputs.sensor = host.settings().inputs.sensor;
        host.setInputs (inputs);
    };
    addAndMakeVisible (straight);
    update();
    startTimer (inputMeterMilliseconds);
}

void InputsPanel::update()
{
    auto wanted = host.settings().inputs;
    auto* const device = host.devices().getCurrentAudioDevice();
    const auto open = device != nullptr ? device->getActiveInputChannels().getHighestBit() + 1 : 0;
    const auto highest = std::max (wanted.sensor, *std::max_element (wanted.inputs.begin(), wanted.inputs.end()));
    const auto inputs = std::min (std::max (open, highest + 1), OutputRouting::maximumOutputs);

    for (std::size_t k = 0; k < choices.size(); ++k)
    {
        if (shownInputs != std::pair (inputs, open))
        {
            choices[k].clear (juce::dontSendNotification);
            choices[k].addItem ("none", noFingerInput);

            for (int i = 0; i < inputs; ++i)
                choices[k].addItem (juce::String (i + 1) + (i < open ? "" : ", not open"), i + 1);
        }

        choices[k].setSelectedId (inputOf (wanted, k) == FingerInputs::none ? noFingerInput : inputOf (wanted, k) + 1,
                                  juce::dontSendNotification);
    }

    shownInputs = { inputs, open };
}

void InputsPanel::timerCallback()
{
    // Taken also while it is hidden: a peak of long ago is none.
    for (std::size_t k = 0; k < levels.size(); ++k)
        levels[k].show (host.processor().session().fingerMeters().inputs.take (static_cast<int> (k)), 0);
}

void InputsPanel::resized()
{
    auto area = getLocalBounds().reduced (panelMargin);

    for (std::size_t k = 0; k < choices.size(); ++k)
    {
        auto row = area.removeFromTop (panelRowHeight).reduced (0, 2);
        names[k].setBounds (row.removeFromLeft (fingerNameWidth));
        choices[k].setBounds (row.removeFromLeft (inputChoiceWidth));
        row.removeFromLeft (panelMargin);

        if (k != sensor)
            levels[k].setBounds (row);
    }

    straight.setBounds (area.removeFromTop (panelRowHeight).reduced (0, 2).removeFromRight (90));
}
} // namespace antinode
