#pragma once

#include "LimiterKernel.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace antinode
{
/** The last guard before the outputs: no sample above its ceramic's limit, no NaN, no Inf.

    A sample beyond its limit is clamped to it and counted per ceramic. A sample that is not finite latches a mute of
   all ceramics: from that sample on all outputs are 0 until reset. Docs/Theory.md, section 6.4.
*/
class VoltageLimiter
{
public:
    /** @param limits  N_b, V, at least 0
        @throws InputError  when a limit is negative or not finite
        [worker] allocates */
    explicit VoltageLimiter (Eigen::VectorXd limits);

    /** Another limit of a ceramic, where it is below its own. @param volts  at least 0; what is not counts as 0
        [audio thread] */
    void setFurtherLimit (std::size_t ceramic, double volts)
    {
        further[static_cast<Eigen::Index> (ceramic)] = volts > 0 ? volts : 0;
    }

    /** Limits in place. @param channels  N_b pointers to count samples each, V
        [audio thread] allocates nothing, locks nothing, any count >= 0 */
    void process (double* const* channels, int count);

    /** Limits in place. @param voltages N_b x n, V. [audio thread] allocates nothing, locks nothing */
    void process (Eigen::Ref<Eigen::MatrixXd> voltages);

    /** The number of clamped samples of each ceramic since the last reset. [audio thread] */
    const std::vector<std::int64_t>& limitedSamples() const { return clamped; }

    /** The same of one ceramic, counted from 0 again from now on. [audio thread] */
    std::int64_t takeLimitedSamples (std::size_t ceramic) { return std::exchange (clamped[ceramic], 0); }

    /** Whether a non-finite sample has muted the output. [audio thread] */
    bool isMuted() const { return muted; }

    /** Unmutes and restarts all counts at 0. [audio thread] */
    void reset();

private:
    void limit (std::size_t ceramic, double* samples, int valid, int count);

    Eigen::VectorXd limits, further; ///< V
    std::vector<std::int64_t> clamped;
    LimiterKernel kernel = limiterKernel();
    bool muted = false;
};

/** Voltages that no amplifier could follow follow as quickly as it can. It stands before a limiter, which has the last
   word, and goes hardly beyond a limit, so that it does not take longer to come back. */
class SlewLimiter
{
public:
    /** @param limits      N_b, V
        @param slews       N_b, V/s; 0: none
        @param sampleRate  Hz
        [worker] */
    SlewLimiter (const Eigen::VectorXd& limits, const Eigen::VectorXd& slews, double sampleRate);

    /** What is not finite stays as it is, for the limiter to find. Inputs and outputs may be the same.
        @param inputs, outputs  N_b pointers to count samples each, V
        [audio thread] allocates nothing, locks nothing */
    void process (const double* const* inputs, double* const* outputs, int count);

    /** From 0 V on. [audio thread] */
    void reset() { last.setZero(); }

private:
    Eigen::VectorXd limits;
    Eigen::VectorXd steps; ///< V from sample to sample.
    Eigen::VectorXd last;  ///< V
};

/** A gain for all ceramics that goes to its target on a straight line: arming, disarming, emergency stop.

    The gain of a sample is computed from how many samples of the ramp are left, so the output does not depend, to the
   bit, on the blocks, and the last sample of a ramp has the target itself. What is not finite stays so: VoltageLimiter
   mutes it. Docs/Theory.md, section 6.4. */
class SafetyRamp
{
public:
    /** @param gain  0..1, where it starts. [worker] */
    explicit SafetyRamp (double gain);

    /** From the next sample on, goes from the present gain to another one.
        @param target   0..1; other values and NaN count as 0, for safety
        @param samples  how many samples the way takes; the last of them has the target. 0 or less: at once
        [audio thread] */
    void setTarget (double target, std::int64_t samples);

    /** The gain of the sample processed last. [audio thread] */
    double gain() const;

    /** Whether the gain has not reached its target. [audio thread] */
    bool isMoving() const { return left > 0; }

    /** Multiplies planar channels, of double or float, in place. @param channels  pointers to count samples each
        [audio thread] allocates nothing, locks nothing, any count >= 0 */
    template <typename Sample>
    void process (Sample* const* channels, int channelCount, int count);

private:
    double start = 1, end = 1;
    std::int64_t length = 0, left = 0; // samples
};
} // namespace antinode
