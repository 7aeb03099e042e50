#pragma once

#include <Eigen/Core>

#include <complex>
#include <optional>
#include <vector>

namespace antinode
{
/** The reconstruction of a voltage from samples. Docs/Theory.md, section 6. */
enum class Reconstruction
{
    bandLimited,  ///< An audio interface: sum u_n K (t/T - n), K the windowed sinc of KaiserSinc.h.
    zeroOrderHold ///< An arbitrary waveform generator: u_n held until the next sample.
};

/** How a drive is played. A rate of 0 stands for the continuous waveform itself. */
struct Playback
{
    Reconstruction reconstruction = Reconstruction::bandLimited;
    double sampleRate = 0; ///< Hz, or 0.
};

/** Voltages of any form as samples, made for one way of playing them. Before the first and after the last they are 0.
 */
struct SampledVoltages
{
    Playback playback;      ///< The only one at which they do what they were designed for; with a rate of more than 0.
    double firstTime = 0;   ///< s from the trigger: when the first sample is played.
    Eigen::MatrixXd values; ///< N_b x N_s, V.
};

/** One exponentially enveloped oscillation: with tau = t - start,
    value (t) = e^{growth tau} (inPhase sin (angularFrequency tau) + quadrature cos (angularFrequency tau)),
    for start <= t < end, else 0. A constant is an oscillation of frequency 0 with a quadrature.
    Docs/Theory.md, section 3; paper (26). */
struct Oscillation
{
    int mode = 0;                ///< The mode that it drives, an index into the modal model.
    double start = 0, end = 0;   ///< s, counted from the trigger.
    double growth = 0;           ///< 1/s
    double angularFrequency = 0; ///< rad/s
    double inPhase = 0, quadrature = 0;
    double freeDecay =
        0; ///< 1/s: of a brake, the decay rate a of its mode when it is left alone; 0 where it is no brake.
    std::complex<double> counterShare = 0; ///< Of a brake: the fraction of its effect on its mode from the part that
                                           ///< rotates against it. Docs/Theory.md, section 6.6.

    /** Whether it brakes a mode: it may then begin later than designed. Docs/Theory.md, section 6.6. [any] */
    bool isBrake() const { return freeDecay > 0 && angularFrequency > 0; }

    /** The exponent p = growth + j angularFrequency, 1/s. [any] */
    std::complex<double> exponent() const { return { growth, angularFrequency }; }

    /** The phasor X with value = Re[X e^{p tau}]. [any] */
    std::complex<double> phasor() const { return { quadrature, -inPhase }; }
};

/** A program to play: oscillations and the matrix that mixes them to the ceramics' voltages,
    U_i (t) = sum_c allocation (i, c) value_c (t). Real-time code needs nothing else. Docs/Theory.md, section 4.
    A free waveform also has samples, which are added; they are bound to a sample rate. */
struct VoltageProgram
{
    std::vector<Oscillation> oscillations;
    Eigen::MatrixXd allocation;    ///< N_b x oscillations, V.
    Eigen::VectorXd voltageLimits; ///< N_b: U_max of each ceramic, V.
    double focusTime = 0;          ///< t_f, s, counted from the trigger.
    std::optional<SampledVoltages> samples = {};
};
} // namespace antinode
