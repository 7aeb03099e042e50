#include "DevicePath.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
DevicePath::DevicePath (std::shared_ptr<const ModalModel> model, double sampleRateToUse)
    : modes (std::move (model)), rate (sampleRateToUse)
{
}

void DevicePath::play (NodeGraph& graph, int limiter, const LagOutputs& lags)
{
    nodes = &graph;
    limiters = { &static_cast<LimiterNode&> (graph.node (limiter)) };

    if (lags)
        limiters.push_back (&static_cast<LimiterNode&> (graph.node (lags.limiter)));

    late = lags.lateSamples (graph);
}

void DevicePath::setFocusLimits (const Eigen::VectorXd& volts)
{
    for (auto* const limiter : limiters)
        limiter->setFocusLimits (volts);
}

void DevicePath::setArmed (bool isArmed)
{
    for (auto* const limiter : limiters)
        limiter->setArmed (isArmed);
}

void DevicePath::setVoltageLimit (double volts)
{
    for (auto* const limiter : limiters)
        limiter->setVoltageLimit (volts);
}

double DevicePath::ringingSeconds() const
{
    return std::log (1000) / decayRates (*modes).minCoeff();
}

bool DevicePath::isSilentAfter (std::int64_t passed) const
{
    return static_cast<double> (passed) > 2 * LimiterNode::rampTime * rate;
}

template <typename Sample>
void DevicePath::writeVoltages (const AudioBlock<Sample>& block, int offset, int count, Outputs voltages) const
{
    const auto ceramics = modes->ceramics.size();
    const auto toFullScale = 1 / modes->fullScaleVoltage;

    for (std::size_t i = 0; i < block.outputs.size(); ++i)
        if (i < ceramics)
            std::transform (voltages[i], voltages[i] + count, block.outputs[i] + offset,
                            [toFullScale] (double volts) { return static_cast<Sample> (volts * toFullScale); });
        else
            std::fill_n (block.outputs[i] + offset, count, Sample (0));
}

void DevicePath::noteVoltages (int count, Outputs voltages, LevelMeters& meters)
{
    for (int i = 0; i < std::min (static_cast<int> (modes->actuators()), LevelMeters::ceramics); ++i)
    {
        meters.notePeak (i, static_cast<float> (absolutePeak (voltages[i], count)));

        for (auto* const limiter : limiters)
            meters.addLimited (i, limiter->takeLimitedSamples (static_cast<std::size_t> (i)));
    }
}

template void DevicePath::writeVoltages (const AudioBlock<float>&, int, int, Outputs) const;
template void DevicePath::writeVoltages (const AudioBlock<double>&, int, int, Outputs) const;

double absolutePeak (const double* samples, int count)
{
    double peak = 0;

    for (int n = 0; n < count; ++n)
        peak = std::max (peak, std::abs (samples[n]));

    return peak;
}
} // namespace antinode
