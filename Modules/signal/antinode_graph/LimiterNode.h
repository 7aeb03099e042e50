#pragma once

#include "Node.h"

#include <antinode_engine/SafetyRamp.h>
#include <antinode_engine/VoltageLimiter.h>

#include <atomic>
#include <limits>
#include <vector>

namespace antinode
{
/** The last guard: silence by a ramp where it is disarmed, no voltage beyond its ceramic's limit, and a latched mute
   where one is not finite. */
class LimiterNode : public Node
{
public:
    /** @param limits  N_b, V @throws InputError  as VoltageLimiter */
    explicit LimiterNode (const Eigen::VectorXd& limits);

    std::string name() const override { return "Limiter"; }
    int inputs() const override { return channels; }
    int outputs() const override { return channels; }
    void prepare (const NodeFormat&) override;
    void process (const NodeBlock&) override;
    void reset() override { voltageLimiter.reset(); }

    /** The duration of a ramp, s. */
    static constexpr double rampTime = 0.005;

    /** From the next block on, ramps all voltages to 0 or back, within rampTime. Armed at first; after prepare() there
       is no ramp, but silence or not, as was said before. [any] */
    void setArmed (bool shouldBeArmed) { wantsArmed = shouldBeArmed; }

    /** From the next block on, no ceramic gets more than this, nor than its own limit or that of what plays. [any]
        @param volts  at least 0 */
    void setVoltageLimit (double volts) { wantedLimit = volts; }

    /** What the focus that plays allows each ceramic, from the next block on: however many foci add up. [any]
        @param volts  N_b, at least 0 */
    void setFocusLimits (const Eigen::VectorXd& volts);

    /** VoltageLimiter::takeLimitedSamples. [audio thread] */
    std::int64_t takeLimitedSamples (std::size_t ceramic) { return voltageLimiter.takeLimitedSamples (ceramic); }

    /** The limiter, for its state. [audio thread] */
    const VoltageLimiter& limiter() const { return voltageLimiter; }

private:
    int channels;
    std::atomic<bool> wantsArmed { true };
    std::atomic<double> wantedLimit { std::numeric_limits<double>::infinity() };
    std::vector<std::atomic<double>> focusLimits; ///< V
    bool isArmed = true;
    std::int64_t rampSamples = 1;
    SafetyRamp ramp { 1 };
    VoltageLimiter voltageLimiter;
};
} // namespace antinode
