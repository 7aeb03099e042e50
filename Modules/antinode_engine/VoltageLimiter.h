#pragma once

#include "LimiterKernel.h"

#include <Eigen/Core>

#include <cstdint>
#include <limits>
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

    /** A limit for all ceramics, where it is below their own. @param volts  at least 0; what is not counts as 0
        [audio thread] */
    void setCommonLimit (double volts) { common = volts > 0 ? volts : 0; }

    /** Limits in place. @param channels  N_b pointers to count samples each, V; in float, limits are rounded down
        [audio thread] allocates nothing, locks nothing, any count >= 0 */
    template <typename Sample>
    void process (Sample* const* channels, int count);

    /** Limits in place. @param voltages N_b x n, V. [audio thread] allocates nothing, locks nothing */
    void process (Eigen::Ref<Eigen::MatrixXd> voltages);

    /** The number of clamped samples of each ceramic since the last reset. [audio thread] */
    const std::vector<std::int64_t>& limitedSamples() const { return clamped; }

    /** Whether a non-finite sample has muted the output. [audio thread] */
    bool isMuted() const { return muted; }

    /** Unmutes and restarts all counts at 0. [audio thread] */
    void reset();

private:
    template <typename Sample>
    const LimiterKernel<Sample>& kernel() const;
    template <typename Sample>
    void limit (std::size_t ceramic, Sample* samples, int valid, int count);

    Eigen::VectorXd limits;
    double common = std::numeric_limits<double>::infinity();
    std::vector<std::int64_t> clamped;
    LimiterKernel<double> doubles;
    LimiterKernel<float> floats;
    bool muted = false;
};
} // namespace antinode
