#include "InputView.h"

#include "PanelSizes.h"

#include <Editor/EditorLook.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_reports/Curve.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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
} // namespace antinode
