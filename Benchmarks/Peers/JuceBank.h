#pragma once

#include <memory>

namespace antinode::bench
{
/** 64 juce::dsp::IIR::Filter of second order in parallel, block by block. */
class JuceBank
{
public:
    /** @param samples  of the longest block */
    JuceBank (double rate, int samples);
    ~JuceBank();
    JuceBank (const JuceBank&) = delete;
    JuceBank& operator= (const JuceBank&) = delete;

    void process (const double* in, double* out, int samples);

private:
    struct Filters;
    std::unique_ptr<Filters> filters;
};
} // namespace antinode::bench
