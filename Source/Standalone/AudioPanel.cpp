#include "AudioPanel.h"

#include "PanelSizes.h"

#include <Editor/EditorLook.h>
#include <antinode_audio/AudioTypes.h>

#include <algorithm>
#include <numeric>

namespace antinode
{
namespace
{
constexpr int nameWidth = 130, buttonWidth = 100;
constexpr auto noInput = "none";

std::string boxText (const juce::ComboBox& box)
{
    return box.getText().toStdString();
}

juce::String text (const std::string& words)
{
    return juce::String::fromUTF8 (words.c_str());
}

void fill (juce::ComboBox& box, const std::vector<std::string>& words, const std::string& chosen)
{
    box.clear (juce::dontSendNotification);

    for (const auto& word : words)
        box.addItem (text (word), box.getNumItems() + 1);

    box.setText (text (chosen), juce::dontSendNotification);
}
} // namespace

AudioPanel::AudioPanel (AudioHost& hostToUse) : host (hostToUse), inputView (hostToUse)
{
    const std::array boxes { &type, &device, &rate, &block, &outputs, &input };
    const std::array words { "Type",           "Device",        "Sample rate, Hz",
                             "Block, samples", "Outputs, 1 to", "Input of the sensor" };

    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
        names[i].setText (words[i], juce::dontSendNotification);
        names[i].setFont (EditorLook::font (EditorLook::smallTextHeight));
        addAndMakeVisible (names[i]);
        addAndMakeVisible (*boxes[i]);
    }

    // All inputs are open where fingers feel them; the first is shown.
    names.back().setVisible (host.playsFoci());
    input.setVisible (host.playsFoci());

    type.setTooltip (deviceTypeDifference());
    refresh.setTooltip ("Searches for devices that were plugged in since the start, and opens the present one again "
                        "where it has stopped");
    failure.setFont (EditorLook::font (EditorLook::smallTextHeight));
    failure.setJustificationType (juce::Justification::topLeft);
    addAndMakeVisible (failure);
    addAndMakeVisible (refresh);
    addAndMakeVisible (inputView);
    input.setTooltip ("What following listens to; its level and spectrum are below. Nothing that comes in is played or "
                      "kept.");
    type.onChange = [this]
    {
        shownType = boxText (type);
        open ({ shownType, {}, 0, 0, {} });
    };
    device.onChange = [this] { open ({ shownType, boxText (device), 0, 0, {} }); };
    rate.onChange = block.onChange = outputs.onChange = input.onChange = [this] { open (shownFormat()); };
    refresh.onClick = [this]
    {
        scannedType.clear();

        if (isPlaying() || host.settings().audio.type.empty())
            update();
        else
            open (host.settings().audio);
    };
    update();
}

bool AudioPanel::isPlaying() const
{
    return host.devices().getCurrentAudioDevice() != nullptr && ! host.hasDeviceStopped();
}

AudioChoice AudioPanel::shownFormat() const
{
    AudioChoice wanted {
        shownType, boxText (device), rate.getText().getDoubleValue(), block.getText().getIntValue(), {}
    };
    wanted.outputs.resize (static_cast<std::size_t> (outputs.getText().getIntValue()));
    std::iota (wanted.outputs.begin(), wanted.outputs.end(), 0);

    if (const auto chosen = input.getText().getIntValue(); chosen > 0)
        wanted.inputs = { chosen - 1 };

    return wanted;
}

void AudioPanel::open (const AudioChoice& choice)
{
    host.attempt (MessageSource::audio, [&] { host.openAudio (choice); });
    update();
}

void AudioPanel::update()
{
    const auto opened = openedAudio (host.devices());
    failure.setText (host.message (MessageSource::audio), juce::dontSendNotification);
    updateDevices (opened);
    updateFormat (opened);
    inputView.refresh();
}

void AudioPanel::updateDevices (const AudioChoice& opened)
{
    const auto types = deviceTypes (host.devices());

    if (! opened.type.empty())
        shownType = opened.type;
    else if (shownType.empty() && ! types.empty())
        shownType = types.front();

    // What does not play is not chosen, so that it can be chosen again.
    fill (type, types, isPlaying() ? shownType : std::string());
    type.setTextWhenNothingSelected (text (shownType));

    // Looking for devices takes its time and may disturb one that plays: so not whenever something is shown.
    if (shownType != scannedType)
        scannedDevices = outputDevices (host.devices(), shownType);

    scannedType = shownType;
    fill (device, scannedDevices, isPlaying() ? opened.device : std::string());
    device.setTextWhenNothingSelected (device.getNumItems() > 0 ? "choose" : "none");
}

void AudioPanel::updateFormat (const AudioChoice& opened)
{
    std::vector<std::string> rates, blocks, counts, inputs { noInput };

    if (auto* const present = host.devices().getCurrentAudioDevice(); isPlaying())
    {
        for (const auto available : present->getAvailableSampleRates())
            rates.push_back (std::to_string (juce::roundToInt (available)));

        for (const auto available : present->getAvailableBufferSizes())
            blocks.push_back (std::to_string (available));

        for (int i = 1; i <= std::min (present->getOutputChannelNames().size(), OutputRouting::maximumOutputs); ++i)
            counts.push_back (std::to_string (i));

        for (int i = 1; i <= std::min (present->getInputChannelNames().size(), maximumDeviceOutputs); ++i)
            inputs.push_back (std::to_string (i));
    }

    const auto isOpen = isPlaying();
    fill (rate, rates, isOpen ? std::to_string (juce::roundToInt (opened.sampleRate)) : std::string());
    fill (block, blocks, isOpen ? std::to_string (opened.blockSize) : std::string());
    fill (input, inputs, opened.inputs.empty() ? noInput : std::to_string (opened.inputs.front() + 1));
    fill (outputs, counts, isOpen ? std::to_string (opened.outputs.size()) : std::string());
}

void AudioPanel::lookAndFeelChanged()
{
    failure.setColour (juce::Label::textColourId, EditorLook::findPalette (*this).warning);
}

void AudioPanel::resized()
{
    auto area = getLocalBounds().reduced (panelMargin);
    const std::array boxes { &type, &device, &rate, &block, &outputs, &input };

    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
        auto row = area.removeFromTop (panelRowHeight).reduced (0, 2);
        names[i].setBounds (row.removeFromLeft (nameWidth));
        boxes[i]->setBounds (row);
    }

    refresh.setBounds (area.removeFromTop (panelRowHeight).reduced (0, 2).removeFromRight (buttonWidth));
    failure.setBounds (area.removeFromTop (2 * panelRowHeight));
    inputView.setBounds (area);
}
} // namespace antinode
