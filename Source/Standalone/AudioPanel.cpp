#include "AudioPanel.h"

#include "PanelParts.h"

#include <Editor/EditorLook.h>
#include <antinode_audio/AudioTypes.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_reports/CurveDrawing.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace antinode
{
namespace
{
constexpr double fadeTime = 0.4; // s: as long as peaks of single bursts are seen
constexpr double leastPower = 1e-20;

/** Hann's window, so scaled that a sine on a line has its amplitude there. */
Eigen::VectorXd scaledHann (Eigen::Index samples)
{
    return Eigen::VectorXd::NullaryExpr (samples,
                                         [samples] (Eigen::Index n)
                                         {
                                             const auto phase = 2 * std::numbers::pi * static_cast<double> (n)
                                                                / static_cast<double> (samples);
                                             return 2 * (1 - std::cos (phase)) / static_cast<double> (samples);
                                         });
}

constexpr int refreshMilliseconds = 50;
constexpr double lowestShown = 20, lowestLevel = -140; // Hz, dB
constexpr float peakFall = 0.97F;                      // a refresh
constexpr float quietestInput = -200;                  // dB
} // namespace

void InputSpectrum::prepare (double sampleRate)
{
    rate = sampleRate;
    waiting.clear();
    powers.resize (0);
}

void InputSpectrum::add (const std::vector<float>& samples)
{
    static const auto window = scaledHann (block);
    waiting.insert (waiting.end(), samples.begin(), samples.end());

    while (static_cast<Eigen::Index> (waiting.size()) >= block)
    {
        const Eigen::VectorXd signal = Eigen::VectorXd::NullaryExpr (
            block, [this] (Eigen::Index n) { return waiting[static_cast<std::size_t> (n)] * window[n]; });
        const Eigen::VectorXd next = forwardFourier (signal).cwiseAbs2();
        const auto kept = std::exp (-static_cast<double> (block) / 2 / rate / fadeTime);
        powers = powers.size() == next.size() ? Eigen::VectorXd (kept * powers + (1 - kept) * next) : next;
        waiting.erase (waiting.begin(), waiting.begin() + block / 2);
    }
}

Eigen::VectorXd InputSpectrum::levels() const
{
    return 10 * powers.array().max (leastPower).log10();
}

double InputSpectrum::lineFrequency (Eigen::Index line) const
{
    return static_cast<double> (line) * rate / static_cast<double> (block);
}

InputView::InputView (AudioHost& hostToUse) : host (hostToUse)
{
    setTitle ("Spectrum of the sensor's input");
    summary.setFont (EditorLook::font (EditorLook::smallTextHeight));
    bar.setTooltip (
        "Peak of the input, from 60 dB below full scale. The lamp shows that samples were clipped: choose a "
        "larger range of the sensor or the input.");
    addAndMakeVisible (summary);
    addAndMakeVisible (bar);
    refresh();
    startTimer (refreshMilliseconds);
}

void InputView::refresh()
{
    auto& tap = host.callback().input();
    const auto samples = tap.take();
    const auto present = host.callback().sampleRate();

    if (present != rate)
    {
        rate = present;
        clippedBefore = tap.clippedSamples();
        spectrum.prepare (rate);
    }

    if (rate > 0)
        spectrum.add (samples);

    levels = spectrum.levels();
    const auto peak = tap.takePeak();
    heldPeak = std::max (peak, heldPeak * peakFall);
    bar.show (peak, tap.clippedSamples() - clippedBefore);
    summary.setText (summaryText (heldPeak), juce::dontSendNotification);

    if (! samples.empty())
        repaint();
}

juce::String InputView::summaryText (float peak) const
{
    const auto number = host.callback().inputNumber();

    if (number < 0)
        return "No input is open: choose the input of the sensor.";

    const auto text = "Input " + juce::String (number + 1) + ": peak "
                      + juce::String (juce::Decibels::gainToDecibels (peak, quietestInput), 1) + " dB of full scale";
    const auto clipped = host.callback().input().clippedSamples() - clippedBefore;
    const auto end = clipped > 0 ? "; CLIPPED, " + juce::String (clipped) + " samples" : juce::String();
    Eigen::Index first = 0, strongest = 0;

    while (first < levels.size() && spectrum.lineFrequency (first) < lowestShown)
        ++first;

    if (first >= levels.size())
        return text + end;

    const auto level = levels.tail (levels.size() - first).maxCoeff (&strongest);
    return text + "; strongest at " + juce::String (juce::roundToInt (spectrum.lineFrequency (first + strongest)))
           + " Hz, " + juce::String (level, 1) + " dB" + end;
}

void InputView::paint (juce::Graphics& g)
{
    const auto& theme = EditorLook::findPalette (*this).charts;
    const auto area = getLocalBounds().withTrimmedTop (2 * panelRowHeight).toFloat();
    const auto rest = drawTitle (g, area, "Spectrum of the input", theme);
    const auto highest = rate > 0 ? rate / 2 : 48000;
    const auto plot = layOutPlot (rest, { "frequency (Hz)", { lowestShown, highest }, true, {}, true },
                                  { "level (dB of full scale)", { lowestLevel, 0 }, false, {}, true }, { 0, 8 }, theme);
    drawGrid (g, plot, theme);
    drawAxes (g, plot, theme);
    CurvePiece points;

    for (Eigen::Index line = 1; line < levels.size(); ++line)
        if (spectrum.lineFrequency (line) >= lowestShown)
            points.push_back (plot.at (spectrum.lineFrequency (line), std::max (lowestLevel, levels[line])));

    g.reduceClipRegion (plot.plot.getSmallestIntegerContainer());
    drawCurve (g, points, { theme.series[2], theme.lineWidth, LineStyle::solid });
}

void InputView::resized()
{
    auto area = getLocalBounds();
    summary.setBounds (area.removeFromTop (panelRowHeight));
    bar.setBounds (area.removeFromTop (panelRowHeight));
}

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
