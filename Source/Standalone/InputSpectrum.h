#pragma once

#include <Eigen/Core>

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
} // namespace antinode
