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
} // namespace antinode
