#pragma once

#include "Node.h"

#include <antinode_base/LockFreeExchange.h>
#include <antinode_engine/AlignedBuffers.h>
#include <antinode_engine/VoltageLimiter.h>
#include <antinode_tracks/FilterPlayer.h>

#include <atomic>
#include <memory>
#include <span>
#include <vector>

namespace antinode
{
/** Where samples from outside come into a graph. Before each block of the graph it is told where they are; the
    parts of the block then take them one after the other. */
class InputNode : public Node
{
public:
    /** @param channels  1 or more */
    explicit InputNode (int channelsToUse) : channels (channelsToUse) {}

    std::string name() const override { return "Input"; }
    int inputs() const override { return 0; }
    int outputs() const override { return channels; }
    void prepare (const NodeFormat&) override {}
    void process (const NodeBlock&) override;
    void reset() override {}

    /** The next block. @param from  as many channels as there are: those that are missing are silent. They must
        last until the graph has played the block
        @param scale  factor of all samples [audio thread] */
    void give (std::span<const float* const> from, double scale);
    void give (std::span<const double* const> from, double scale);

private:
    int channels;
    std::span<const float* const> floats;
    std::span<const double* const> doubles;
    double gain = 1;
    int position = 0; ///< In the block.
};

/** Inputs of fingers in, voltages out, by filters. Banks of filters come from a worker and follow each other by a
    cross-fade; before the first one all voltages are 0. */
class FilterNode : public Node
{
public:
    /** What 1.0 of an input may be at most, m. */
    static constexpr double largestLevel = 1e-3;

    /** Of a sample of an input: what is beyond counts as this, so that no sum overflows. */
    static constexpr float largestSample = 100;

    /** The length of a cross-fade, s. */
    static constexpr double fadeTime = 0.005;

    /** Of the high-pass of first order that takes an offset off the inputs, which filters would pass, Hz: so low that
       at 40 Hz it changes an input by -38 dB. */
    static constexpr double offsetCorner = 0.5;

    /** @param ceramics, inputs  1 or more
        @param band              of the filters: each finger's motion is told within it
        @param settings          of the filters; the latency may change with a bank
        @throws InputError  as filterTiming
        [worker] */
    FilterNode (int ceramics, int inputs, TrackBand, const FilterSettings& settings, const SkinThreshold&);
    ~FilterNode() override;
    FilterNode (const FilterNode&) = delete;
    FilterNode& operator= (const FilterNode&) = delete;

    std::string name() const override { return "Filters"; }
    int inputs() const override { return static_cast<int> (gains.size()); }
    int outputs() const override { return ceramics; }
    void prepare (const NodeFormat&) override;
    void process (const NodeBlock&) override;
    void reset() override;

    /** Where banks of these sizes come from. */
    HandOver<FilterBank>& banks() { return exchange; }

    /** How far 1.0 of an input moves its finger, m, from the next block on within 5 ms. @param metres  0 to
        largestLevel; others count as 0 [audio thread] */
    void setLevel (std::size_t input, double metres) { wantedLevels[input] = metres / largestLevel; }

    /** Samples per sample of the filters, and of what the inputs ask for. [any] */
    Eigen::Index factor() const { return factorOfFilters; }

    /** What the inputs ask for. [audio thread] */
    InputMotion& motion() { return asked; }

private:
    void takeInputs (const NodeBlock&);
    float withoutOffset (std::size_t input, double sample);
    void exchangeBanks();

    static constexpr double rampTime = 0.005; // s

    int ceramics;
    Eigen::Index factorOfFilters;
    HandOver<FilterBank> exchange;
    std::unique_ptr<const FilterBank> playing; ///< Of the audio thread, as all below.
    std::unique_ptr<const FilterBank> coming;  ///< While it fades in.
    FilterPlayer player;
    InputMotion asked;
    std::vector<double> offsets;              ///< Of the inputs.
    double offsetShare = 0;                   ///< Of a sample in its offset.
    std::vector<double> wantedLevels, levels; ///< Over the largest.
    std::vector<SafetyRamp> gains;
    std::int64_t rampSamples = 1;
    PlanarBuffer<float> scaled; ///< m
    Eigen::VectorXf sample, voltages;
};
} // namespace antinode
