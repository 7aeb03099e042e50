#include "JuceBank.h"

#include <algorithm>
#include <juce_dsp/juce_dsp.h>
#include <vector>

namespace antinode::bench
{
struct JuceBank::Filters
{
    std::vector<juce::dsp::IIR::Filter<double>> modes;
    std::vector<double> one;
};

JuceBank::JuceBank (double rate, int samples) : filters (std::make_unique<Filters>())
{
    filters->modes.resize (64);
    filters->one.resize (static_cast<std::size_t> (samples));

    for (std::size_t k = 0; k < filters->modes.size(); ++k)
    {
        auto& mode = filters->modes[k];
        mode.coefficients =
            juce::dsp::IIR::Coefficients<double>::makeBandPass (rate, 100.0 * static_cast<double> (k + 1), 50);
        mode.prepare ({ rate, static_cast<juce::uint32> (samples), 1 });
    }
}

JuceBank::~JuceBank() = default;

void JuceBank::process (const double* in, double* out, int samples)
{
    auto* one = filters->one.data();
    const auto count = static_cast<std::size_t> (samples);
    const juce::dsp::AudioBlock<const double> input (&in, 1, count);
    juce::dsp::AudioBlock<double> output (&one, 1, count);
    std::fill (out, out + samples, 0.0);

    for (auto& mode : filters->modes)
    {
        mode.process (juce::dsp::ProcessContextNonReplacing<double> (input, output));
        std::transform (one, one + samples, out, out, [] (double a, double b) { return a + b; });
    }
}
} // namespace antinode::bench
