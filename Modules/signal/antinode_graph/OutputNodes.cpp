#include "OutputNodes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
ChannelGainNode::ChannelGainNode (int channelsToUse)
    : channels (channelsToUse), targets (static_cast<std::size_t> (channelsToUse), 1.0),
      ramps (static_cast<std::size_t> (channelsToUse), SafetyRamp (1))
{
}

double ChannelGainNode::targetGain (int channel) const
{
    const auto isMuted = channel < 64 && ((wantedMutes.load (std::memory_order_relaxed) >> channel) & 1U) != 0;
    return isMuted ? 0.0 : wantedGain.load (std::memory_order_relaxed);
}

void ChannelGainNode::prepare (const NodeFormat& format)
{
    rampSamples = std::max<std::int64_t> (1, std::llround (rampTime * format.sampleRate));

    for (int i = 0; i < channels; ++i)
    {
        const auto channel = static_cast<std::size_t> (i);
        targets[channel] = targetGain (i);
        ramps[channel] = SafetyRamp (targets[channel]);
    }
}

void ChannelGainNode::process (const NodeBlock& block)
{
    for (int i = 0; i < channels; ++i)
    {
        const auto channel = static_cast<std::size_t> (i);
        std::copy (block.inputs[i], block.inputs[i] + block.count, block.outputs[i]);

        if (const auto target = targetGain (i); target != targets[channel])
        {
            targets[channel] = target;
            ramps[channel].setTarget (target, rampSamples);
        }

        if (ramps[channel].isMoving() || ramps[channel].gain() != 1)
            ramps[channel].process (block.outputs + i, 1, block.count);
    }
}

SlewNode::SlewNode (Eigen::VectorXd limitsToKeep, Eigen::VectorXd slewsToKeep)
    : limits (std::move (limitsToKeep)), slews (std::move (slewsToKeep))
{
}

void SlewNode::prepare (const NodeFormat& format)
{
    limiter.emplace (limits, slews, format.sampleRate);
}

void SlewNode::reset()
{
    if (limiter)
        limiter->reset();
}

void SlewNode::process (const NodeBlock& block)
{
    limiter->process (block.inputs, block.outputs, block.count);
}

LimiterNode::LimiterNode (const Eigen::VectorXd& limits)
    : channels (static_cast<int> (limits.size())), focusLimits (static_cast<std::size_t> (channels)),
      voltageLimiter (limits)
{
    setFocusLimits (limits);
}

void LimiterNode::setFocusLimits (const Eigen::VectorXd& volts)
{
    for (Eigen::Index i = 0; i < channels; ++i)
        focusLimits[static_cast<std::size_t> (i)] = volts[i];
}

void LimiterNode::prepare (const NodeFormat& format)
{
    rampSamples = std::max<std::int64_t> (1, std::llround (rampTime * format.sampleRate));
    isArmed = wantsArmed.load();
    ramp = SafetyRamp (isArmed ? 1 : 0);
}

void LimiterNode::process (const NodeBlock& block)
{
    for (int i = 0; i < channels; ++i)
        std::copy (block.inputs[i], block.inputs[i] + block.count, block.outputs[i]);

    if (const auto wanted = wantsArmed.load (std::memory_order_relaxed); wanted != isArmed)
    {
        isArmed = wanted;
        ramp.setTarget (isArmed ? 1 : 0, rampSamples);
    }

    ramp.process (block.outputs, channels, block.count);

    const auto ofAll = wantedLimit.load (std::memory_order_relaxed);

    for (std::size_t i = 0; i < focusLimits.size(); ++i)
        voltageLimiter.setFurtherLimit (i, std::min (ofAll, focusLimits[i].load (std::memory_order_relaxed)));

    voltageLimiter.process (block.outputs, block.count);
}

LagNode::LagNode (std::shared_ptr<const ModalModel> modelToUse, LagDirection directionToUse)
    : model (std::move (modelToUse)), direction (directionToUse)
{
}

void LagNode::prepare (const NodeFormat& format)
{
    filters = lagFilters (*model, format.sampleRate, direction);
    recent = Eigen::MatrixXd::Zero (filters.reach() + format.longestBlock, model->actuators());
}

void LagNode::process (const NodeBlock& block)
{
    const auto taps = filters.taps.rows(), before = filters.reach();

    for (Eigen::Index i = 0; i < recent.cols(); ++i)
    {
        auto samples = recent.col (i);
        std::copy (block.inputs[i], block.inputs[i] + block.count, samples.data() + before);
        const auto oldest = before + 1 - taps - filters.starts[static_cast<std::size_t> (i)];

        for (int n = 0; n < block.count; ++n)
            block.outputs[i][n] = filters.taps.col (i).dot (samples.segment (oldest + n, taps));

        std::copy (samples.data() + block.count, samples.data() + block.count + before, samples.data());
    }
}

std::int64_t LagOutputs::lateSamples (NodeGraph& graph) const
{
    return *this ? graph.node (filters).latencySamples() : 0;
}

LagOutputs addLagOutputs (NodeGraph& graph, const std::shared_ptr<const ModalModel>& model, int source)
{
    LagOutputs added;

    if (! needsLagFilters (*model))
        return added;

    added.filters = graph.add (std::make_unique<LagNode> (model, LagDirection::undo), source);
    auto last = added.filters;

    if (const auto slews = slewLimits (*model); slews.maxCoeff() > 0)
        last = graph.add (std::make_unique<SlewNode> (voltageLimits (*model), slews), last);

    added.limiter = graph.add (std::make_unique<LimiterNode> (voltageLimits (*model)), last);
    return added;
}
} // namespace antinode
