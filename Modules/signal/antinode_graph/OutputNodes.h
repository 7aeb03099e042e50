#pragma once

#include "Node.h"
#include "NodeGraph.h"

#include <Eigen/Core>
#include <antinode_engine/LagFilters.h>
#include <antinode_engine/VoltageLimiter.h>
#include <antinode_model/ModalModel.h>

#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace antinode
{
/** One gain for all ceramics, and a mute for each: changes are ramps of 5 ms. It stands before the limiter, so it can
   never raise a voltage beyond its limit. */
class ChannelGainNode : public Node
{
public:
    /** @param channels  1 or more */
    explicit ChannelGainNode (int channels);

    std::string name() const override { return "Channel gains"; }
    int inputs() const override { return channels; }
    int outputs() const override { return channels; }
    void prepare (const NodeFormat&) override;
    void process (const NodeBlock&) override;
    void reset() override {}

    /** @param gain  0 to 1; others count as 0. [any] */
    void setGain (double gain) { wantedGain = gain; }

    /** @param mask  bit i set: ceramic i + 1 is silent; channels beyond 64 cannot be muted. [any] */
    void setMutes (std::uint64_t mask) { wantedMutes = mask; }

private:
    double targetGain (int channel) const;

    static constexpr double rampTime = 0.005; // s

    int channels;
    std::atomic<double> wantedGain { 1 };
    std::atomic<std::uint64_t> wantedMutes { 0 };
    std::vector<double> targets;
    std::vector<SafetyRamp> ramps;
    std::int64_t rampSamples = 1;
};

/** Keeps slew rates, before a limiter. */
class SlewNode : public Node
{
public:
    /** @param limits  N_b, V
        @param slews   N_b, V/s; 0: none
        [worker] */
    SlewNode (Eigen::VectorXd limits, Eigen::VectorXd slews);

    std::string name() const override { return "Slew rates"; }
    int inputs() const override { return static_cast<int> (limits.size()); }
    int outputs() const override { return inputs(); }
    void prepare (const NodeFormat&) override;
    void process (const NodeBlock&) override;
    void reset() override;

private:
    Eigen::VectorXd limits, slews;
    std::optional<SlewLimiter> limiter; ///< None before prepare().
};

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

/** Undoes or applies what ceramics lag, one filter a ceramic. */
class LagNode : public Node
{
public:
    LagNode (std::shared_ptr<const ModalModel>, LagDirection);

    std::string name() const override { return "Lags"; }
    int inputs() const override { return static_cast<int> (model->actuators()); }
    int outputs() const override { return inputs(); }
    void prepare (const NodeFormat&) override;
    void process (const NodeBlock&) override;
    void reset() override { recent.setZero(); }
    std::int64_t latencySamples() const override { return filters.lateness; }

private:
    std::shared_ptr<const ModalModel> model;
    LagDirection direction;
    LagFilters filters;
    Eigen::MatrixXd recent; ///< Samples x N_b: those before the block that are still needed, then the block.
};

/** What stands between the voltages that ceramics are to act on and the outputs, where ceramics lag: filters, slew
   rates and a limiter of their own. */
struct LagOutputs
{
    int filters = NodeGraph::noSource, limiter = NodeGraph::noSource; ///< Indices of nodes; noSource: nothing lags.

    /** Whether there is anything. [any] */
    explicit operator bool() const { return limiter != NodeGraph::noSource; }

    /** By how much all that is designed happens later. [any, after prepare] */
    std::int64_t lateSamples (NodeGraph&) const;
};

/** Adds them behind a node. [worker] */
LagOutputs addLagOutputs (NodeGraph&, const std::shared_ptr<const ModalModel>&, int source);
} // namespace antinode
