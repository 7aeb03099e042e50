#include "InputPanels.h"

#include "PanelParts.h"
#include "TouchInput.h"

#include <Editor/EditorLook.h>

#include <algorithm>
#include <string_view>

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

namespace
{
constexpr int panelLookMilliseconds = 1000;
}

MidiPanel::MidiPanel (AudioHost& hostToUse) : host (hostToUse)
{
    all.setToggleState (host.settings().midi.all, juce::dontSendNotification);
    all.onClick = [this] { choose(); };
    none.setFont (EditorLook::font (EditorLook::smallTextHeight));
    addAndMakeVisible (all);
    addChildComponent (none);
    update();
    startTimer (panelLookMilliseconds);
}

void MidiPanel::update()
{
    const auto available = host.midi().available();
    none.setVisible (available.isEmpty());

    if (available != devices)
    {
        devices = available;
        buttons.clear();

        for (const auto& device : devices)
        {
            buttons.push_back (std::make_unique<juce::ToggleButton> (device.name));
            buttons.back()->onClick = [this] { choose(); };
            addAndMakeVisible (*buttons.back());
        }

        resized();
    }

    const auto& chosen = host.settings().midi;

    for (std::size_t i = 0; i < buttons.size(); ++i)
    {
        const auto identifier = devices[static_cast<int> (i)].identifier.toStdString();
        const auto isNamed = std::find (chosen.inputs.begin(), chosen.inputs.end(), identifier) != chosen.inputs.end();
        buttons[i]->setToggleState (chosen.all || isNamed, juce::dontSendNotification);
        buttons[i]->setEnabled (! chosen.all);
    }
}

/** Inputs that are not plugged in at the moment stay selected. */
void MidiPanel::choose()
{
    auto chosen = host.settings().midi;
    chosen.all = all.getToggleState();

    for (std::size_t i = 0; i < buttons.size(); ++i)
    {
        const auto identifier = devices[static_cast<int> (i)].identifier.toStdString();
        std::erase (chosen.inputs, identifier);

        if (buttons[i]->getToggleState())
            chosen.inputs.push_back (identifier);
    }

    host.setMidi (chosen);
    update();
}

void MidiPanel::resized()
{
    auto area = getLocalBounds().reduced (panelMargin);
    all.setBounds (area.removeFromTop (panelRowHeight));
    none.setBounds (area.withHeight (panelRowHeight));

    for (auto& button : buttons)
        button->setBounds (area.removeFromTop (panelRowHeight).withTrimmedLeft (2 * panelMargin));
}

namespace
{
constexpr int fieldNameWidth = 90, fieldWidth = 80, choiceWidth = 190, countMilliseconds = 250;
constexpr auto thisComputer = "127.0.0.1", wholeNetwork = "0.0.0.0";

/** What a choice of cursorWords does. */
juce::String cursorText (const AudioHost& host, std::string_view word, std::string_view finger)
{
    if (! finger.empty())
        return (host.playsFoci() ? "rest as " : "play as ") + juce::String (std::string (word)) + " fingers";

    return host.playsFoci() ? "play foci" : "play fingers as they are";
}
} // namespace

TouchPanel::TouchPanel (AudioHost& hostToUse) : host (hostToUse)
{
    const auto& ports = host.settings().touch;
    oscPort.setText (juce::String (ports.oscPort), false);
    tuioPort.setText (juce::String (ports.tuioPort), false);
    network.setToggleState (ports.address != thisComputer, juce::dontSendNotification);
    status.setJustificationType (juce::Justification::topLeft);

    for (auto* const label : { &oscName, &tuioName, &cursorsName, &status })
        label->setFont (EditorLook::font (EditorLook::smallTextHeight));

    for (auto* const editor : { &oscPort, &tuioPort })
    {
        editor->setInputRestrictions (5, "0123456789");
        editor->setFont (EditorLook::font (EditorLook::smallTextHeight));
        editor->setJustification (juce::Justification::centredLeft);
        editor->setTooltip ("UDP port; 0: off");
        editor->setEscapeAndReturnKeysConsumed (false);
        editor->onReturnKey = [this] { apply(); };
    }

    for (std::size_t i = 0; i < cursorWords.size(); ++i)
    {
        const auto [word, finger] = cursorWords[i];
        cursors.addItem (cursorText (host, word, finger), static_cast<int> (i) + 1);

        if (finger == ports.finger)
            cursors.setSelectedId (static_cast<int> (i) + 1, juce::dontSendNotification);
    }

    cursors.setTooltip (host.playsFoci()
                            ? "What TUIO cursors do. Fingers damp the surface; no focus is designed for them"
                            : "What a finger is to the surface that a touch puts down");
    applyButton.onClick = [this] { apply(); };

    for (auto* const child : std::initializer_list<juce::Component*> {
             &oscName, &tuioName, &status, &oscPort, &tuioPort, &cursorsName, &cursors, &network, &applyButton })
        addAndMakeVisible (child);

    showState();
    startTimer (countMilliseconds);
}

void TouchPanel::apply()
{
    const auto finger = cursorWords[static_cast<std::size_t> (cursors.getSelectedId() - 1)].second;
    const TouchPorts wanted { oscPort.getText().getIntValue(), tuioPort.getText().getIntValue(),
                              network.getToggleState() ? wholeNetwork : thisComputer, std::string (finger),
                              host.settings().touch.senders };
    host.attempt (MessageSource::ports, [&] { host.setTouch (wanted); });
    showState();
}

void TouchPanel::showState()
{
    const auto failure = host.message (MessageSource::ports);
    status.setText (failure.isNotEmpty() ? failure : host.touchStatus(), juce::dontSendNotification);
}

void TouchPanel::lookAndFeelChanged()
{
    for (auto* const editor : { &oscPort, &tuioPort })
        editor->applyColourToAllText (EditorLook::findPalette (*this).text);
}

void TouchPanel::resized()
{
    auto area = getLocalBounds().reduced (panelMargin);
    const auto place = [&] (juce::Component& name, juce::Component& field, int width)
    {
        auto row = area.removeFromTop (panelRowHeight).reduced (0, 2);
        name.setBounds (row.removeFromLeft (fieldNameWidth));
        field.setBounds (row.removeFromLeft (width));
    };
    place (oscName, oscPort, fieldWidth);
    place (tuioName, tuioPort, fieldWidth);
    place (cursorsName, cursors, choiceWidth);
    network.setBounds (area.removeFromTop (panelRowHeight));
    applyButton.setBounds (area.removeFromTop (panelRowHeight).reduced (0, 2).removeFromLeft (fieldWidth));
    area.removeFromTop (panelMargin);
    status.setBounds (area.removeFromTop (4 * panelRowHeight));
}
} // namespace antinode
