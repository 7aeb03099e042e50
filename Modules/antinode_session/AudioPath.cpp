#include "AudioPath.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr int longestPart = 512;         // samples that are processed at once: few enough to stay in the cache
constexpr std::size_t mostEvents = 4096; // of one part of a block

double peakOf (const double* samples, int count)
{
    double peak = 0;

    for (int n = 0; n < count; ++n)
        peak = std::max (peak, std::abs (samples[n]));

    return peak;
}

template <typename Sample>
void copyScaled (const double* from, Sample* to, int count, double gain)
{
    for (int n = 0; n < count; ++n)
        to[n] = static_cast<Sample> (from[n] * gain);
}
} // namespace

AudioPath::AudioPath (std::shared_ptr<const ModalModel> model, double sampleRateToUse, PlayerSettings settings,
                      const Eigen::MatrixXd& probeShapes)
    : modes (std::move (model)), rate (sampleRateToUse), standard (standardGraph (modes, settings, probeShapes)),
      toFullScale (1 / modes->fullScaleVoltage)
{
    standard.graph.prepare ({ rate, longestPart });
    designs = std::make_unique<DesignWorker> (standard.playerNode().player().handOver());
    outputs = PlanarBuffer<double> (standard.graph.outputs(), longestPart);
    partEvents.reserve (mostEvents);
}

bool AudioPath::isSilentAfter (std::int64_t passed) const
{
    return static_cast<double> (passed) > 2 * LimiterNode::rampTime * rate;
}

template <typename Sample>
void AudioPath::process (const OutputBlock<Sample>& block, std::span<const FocusEvent> events,
                         const PlayControls& controls, LevelMeters& meters, ProbeTrace& trace)
{
    standard.gainNode().setGain (controls.outputTrim);
    standard.gainNode().setMutes (controls.mutes);
    standard.limiterNode().setArmed (controls.isArmed);
    standard.limiterNode().setVoltageLimit (controls.voltageLimit);
    monitorGain = controls.monitorGain;
    auto next = events.begin();

    for (int offset = 0; offset < block.count;)
    {
        const auto count = std::min (longestPart, block.count - offset);
        const auto isLast = offset + count == block.count;
        partEvents.clear();

        for (; next != events.end() && (isLast || next->offset < offset + count) && partEvents.size() < mostEvents;
             ++next)
        {
            partEvents.push_back (*next);
            partEvents.back().offset -= offset;
        }

        processPart (block, offset, count, partEvents);
        note (count, meters, trace);
        offset += count;
    }
}

template <typename Sample>
void AudioPath::processPart (const OutputBlock<Sample>& block, int offset, int count,
                             std::span<const FocusEvent> events)
{
    standard.graph.process (outputs.channels(), count, events);
    const auto ceramics = static_cast<std::size_t> (modes->actuators());

    for (std::size_t i = 0; i < block.ceramics.size(); ++i)
        if (i < ceramics)
            copyScaled (outputs.channel (i), block.ceramics[i] + offset, count, toFullScale);
        else
            std::fill_n (block.ceramics[i] + offset, count, Sample (0));

    for (std::size_t i = 0; i < block.monitor.size(); ++i)
        if (i < probes)
            copyScaled (outputs.channel (ceramics + i), block.monitor[i] + offset, count, monitorGain);
        else
            std::fill_n (block.monitor[i] + offset, count, Sample (0));
}

void AudioPath::note (int count, LevelMeters& meters, ProbeTrace& trace)
{
    const auto& limiter = standard.limiterNode().limiter();
    const auto ceramics = static_cast<std::size_t> (modes->actuators());

    for (std::size_t i = 0; i < std::min<std::size_t> (ceramics, LevelMeters::ceramics); ++i)
    {
        meters.notePeak (static_cast<int> (i), static_cast<float> (peakOf (outputs.channel (i), count)));
        meters.noteLimited (static_cast<int> (i), limiter.limitedSamples()[i]);
    }

    for (std::size_t i = 0; i < probes; ++i)
        meters.noteProbe (static_cast<int> (i), static_cast<float> (peakOf (outputs.channel (ceramics + i), count)));

    auto& player = standard.playerNode().player();
    meters.noteState (limiter.isMuted(), player.activeVoices(), player.counters().triggered);
    trace.write (outputs.channel (ceramics), count);
}

template void AudioPath::process (const OutputBlock<float>&, std::span<const FocusEvent>, const PlayControls&,
                                  LevelMeters&, ProbeTrace&);
template void AudioPath::process (const OutputBlock<double>&, std::span<const FocusEvent>, const PlayControls&,
                                  LevelMeters&, ProbeTrace&);
} // namespace antinode
