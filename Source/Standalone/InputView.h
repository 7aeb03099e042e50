#pragma once

#include "AudioHost.h"
#include "InputSpectrum.h"
#include "LevelBar.h"

#include <antinode_charts/PlotFrame.h>

namespace antinode
{
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
} // namespace antinode
