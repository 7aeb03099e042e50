#pragma once

#include "VoltageSynthesiser.h"

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace antinode
{
/** The brakes of a focus, ready to be begun when they were designed to, or later, when a note ends: they meet their
   modes where free decay has taken them. Read only once made. Docs/Theory.md, section 6.6. */
class PlayableBrake
{
public:
    static constexpr std::size_t maximumOscillations = 2048;

    /** @param brakes  a program of brakes only, 1 to maximumOscillations of them
        @throws InputError  as VoltageSynthesiser
        [worker] allocates */
    PlayableBrake (const VoltageProgram& brakes, Playback);

    /** The brakes as they were designed. [any] */
    const VoltageSynthesiser& designed() const { return synthesiser; }

    /** The first sample that may be played, from the trigger, where the brakes begin as designed. [any] */
    std::int64_t startSample() const { return start; }

    /** Nothing sounds from this sample on where they begin as designed. [any] */
    std::int64_t endSample() const { return end; }

    /** The number of samples of free decay after which every mode is down to 0.1 %, with nothing left to brake. [any]
     */
    std::int64_t longestDelay() const { return longest; }

    /** The factors of the brakes if they start later.
        @param delay    samples, 0 or more
        @param factors  room for one an oscillation
        [audio thread] an exponential, a sine and a cosine for every mode: some 10 us for 2048 of them */
    void factorsAfter (std::int64_t delay, std::span<std::complex<double>> factors) const;

private:
    /** The mode of an oscillation, and how its brake rotates with it. */
    struct Mode
    {
        double decay = 0, frequency = 0;    // a, 1/s, and b, rad/s
        std::complex<double> with, against; // the factor is with e^{s tau} - against conj (e^{s tau})

        bool isAs (const Mode& other) const
        {
            return decay == other.decay && frequency == other.frequency && with == other.with
                   && against == other.against;
        }
    };

    static Mode toMode (const Oscillation&);

    VoltageSynthesiser synthesiser;
    double rate;
    std::int64_t start = 0, end = 0, longest = 0;
    std::vector<Mode> modes;
};
} // namespace antinode
