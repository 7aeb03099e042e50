#pragma once

#include <antinode_model/Oscillation.h>
#include <antinode_model/Playback.h>

#include <Eigen/Core>

#include <complex>
#include <cstdint>
#include <vector>

namespace antinode
{
/** Force oscillations and the allocation mixer: a VoltageProgram as samples.

    Sample n stands for the time t = focusTime + (n - focusSample) / rate, so that the focus falls exactly on a sample.
    Where an oscillation starts or ends on a sample (within 1e-6 of the interval), a band-limited playback gets the mean of
    both sides (the value a band-limited signal has at a step), a zero-order hold the value from there on. Each sample is
    computed from its absolute index, so the output does not depend, to the bit, on the blocks.

    An oscillation Re[X e^{p tau}] is a phasor factored in two: X e^{p tau} at the first sample of a tile of 64, from extended
    precision, times e^{p j / rate} from a table. So its error does not grow with time: below 1e-12 of the envelope after
    1 s at 192 kHz (where long double is wider than double). Docs/Theory.md, section 6.1.
*/
class VoltageSynthesiser
{
public:
    /** @throws InputError  when the rate is not finite and positive, sizes do not agree, a number of the program is not finite, an
                            oscillation ends before it starts, or its envelope leaves the range of numbers
        [worker] allocates */
    VoltageSynthesiser (VoltageProgram, Playback);

    /** The sample on which the focus falls: round (focusTime * rate). [any] */
    std::int64_t focusSample() const { return focus; }

    /** Voltages of the samples first .. first + n - 1.
        @param voltages  N_b x n, V
        [audio thread] allocates nothing, locks nothing, any n >= 0, any order of blocks */
    void process (std::int64_t first, Eigen::Ref<Eigen::MatrixXd> voltages) const;

private:
    /** Where an oscillation starts or ends: its weight is 0 before the sample, `weight` there and 1 after it. */
    struct Edge
    {
        std::int64_t sample = 0;
        double weight = 1;

        double weightAt (std::int64_t n) const { return n < sample ? 0.0 : (n == sample ? weight : 1.0); }
    };

    struct Voice
    {
        Edge start, end;
        long double focusOffset = 0; // s, from its start to the focus
    };

    Edge edgeAt (double time, Reconstruction) const;
    std::complex<double> phasorAt (std::size_t oscillation, std::int64_t sample) const;
    void addOscillation (std::size_t oscillation, std::int64_t tile, std::int64_t first,
                         Eigen::Ref<Eigen::MatrixXd> voltages) const;

    VoltageProgram program;
    double rate = 0;
    std::int64_t focus = 0;
    std::vector<Voice> voices;
    Eigen::MatrixXcd rotations; // 64 x oscillations: e^{p j / rate}
};
} // namespace antinode
