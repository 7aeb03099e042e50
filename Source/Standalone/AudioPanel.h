#pragma once

#include "AudioHost.h"
#include "PanelParts.h"

#include <Eigen/Core>
#include <antinode_reports/PlotFrame.h>
#include <juce_gui_basics/juce_gui_basics.h>

#include <array>
#include <deque>
#include <vector>

namespace antinode
{
/** The spectrum of the last moments of an input: blocks with a Hann window that overlap by half, whose powers fade. */
class InputSpectrum
{
public:
    /** Samples of a block: 6 Hz from line to line at 96 kHz. */
    static constexpr Eigen::Index block = 1 << 14;

    /** Begins again. @param sampleRate  Hz, above 0 [message thread] */
    void prepare (double sampleRate);

    /** The next samples, share of full scale. [message thread] */
    void add (const std::vector<float>& samples);

    /** dB of full scale, where a sine that just reaches full scale is 0 dB; block/2 + 1 lines, empty before the first
        block. [message thread] */
    Eigen::VectorXd levels() const;

    /** Hz. [message thread] */
    double lineFrequency (Eigen::Index line) const;

private:
    double rate = 0;
    std::deque<float> waiting;
    Eigen::VectorXd powers; ///< Squared peak amplitudes, share of full scale.
};

/** What a sensor's input hears: level with a lamp for clipped samples, and the spectrum. [message thread] */
class InputView final : public juce::Component, private juce::Timer
{
public:
    /** @param hostToUse  outlives this */
    explicit InputView (AudioHost& hostToUse);

    /** Reads what came in since the last call. */
    void refresh();

    /** "Input 3: peak -12.3 dB of full scale; strongest at 612 Hz, -20.1 dB", or why there is nothing. */
    juce::String words() const { return summary.getText(); }

    void paint (juce::Graphics&) override;
    void resized() override;

private:
    void timerCallback() override { refresh(); }
    juce::String summaryText (float peak) const;

    AudioHost& host;
    InputSpectrum spectrum;
    Eigen::VectorXd levels;
    double rate = 0; ///< Hz, of the spectrum.
    std::int64_t clippedBefore = 0;
    float heldPeak = 0;
    juce::Label summary;
    LevelBar bar;
};

/** The audio device and its settings. JUCE's own panel is not used, because it has a button that plays half of full
    scale past the router. */
class AudioPanel final : public juce::Component
{
public:
    /** @param hostToUse  outlives this [message thread] */
    explicit AudioPanel (AudioHost& hostToUse);

    /** Shows what is open, and what there is. [message thread] */
    void update();

    void lookAndFeelChanged() override;
    void resized() override;

private:
    void updateDevices (const AudioChoice&);
    void updateFormat (const AudioChoice&);
    void open (const AudioChoice&);
    AudioChoice shownFormat() const;
    bool isPlaying() const;

    AudioHost& host;
    juce::ComboBox type, device, rate, block, outputs, input;
    std::array<juce::Label, 6> names;
    juce::TextButton refresh { "Refresh" };
    juce::Label failure;
    InputView inputView;
    std::string shownType;   ///< Also where its device does not play.
    std::string scannedType; ///< Of the next line.
    std::vector<std::string> scannedDevices;
};
} // namespace antinode
