#pragma once

#include "Node.h"

#include <antinode_engine/SafetyRamp.h>

#include <atomic>
#include <memory>
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
} // namespace antinode
