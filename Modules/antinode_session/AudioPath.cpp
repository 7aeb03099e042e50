#include "AudioPath.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr int longestPart = 512;    // samples that are processed at once: few enough to stay in the cache
constexpr int longestOpenPart = 64; // the same where every oscillation has a channel
} // namespace

AudioPath::AudioPath (std::shared_ptr<const ModalModel> model, double sampleRateToUse,
                      const Eigen::MatrixXd& probeShapes, const GraphChoice& graph, Listening whoListens)
    : DevicePath (std::move (model), sampleRateToUse),
      standard (graph.isOpen ? openGraph (modes, PlayerSettings {}, probeShapes, graph.insert)
                             : standardGraph (modes, PlayerSettings {}, probeShapes)),
      listening (std::move (whoListens))
{
    standard.graph.prepare ({ rate, graph.isOpen ? longestOpenPart : longestPart });
    play (standard.graph, standard.limiter, standard.lags);
    designs = std::make_unique<DesignWorker> (standard.voiceNode().voices().handOver());
}

template <typename Sample>
void AudioPath::process (const AudioBlock<Sample>& block, std::span<const FocusEvent> events,
                         const PlayControls& controls, LevelMeters& meters, ProbeTrace& trace)
{
    auto& voices = standard.voiceNode().voices();
    voices.setSettings (controls.notes);
    standard.gainNode().setGain (controls.outputTrim);
    standard.gainNode().setMutes (controls.mutes | listening.idle);
    setArmed (controls.isArmed);

    for (auto* const limiter : limiters())
        if (limiter != nullptr)
            limiter->setVoltageLimit (controls.voltageLimit);

    monitorGain = controls.monitorGain;
    standard.graph.processParts (block.count, events,
                                 [&] (int offset, int count, Outputs outputs)
                                 {
                                     // Before its samples are written over.
                                     if (listening.tap != nullptr)
                                         listening.tap->write (
                                             outputs, block.sensor != nullptr ? block.sensor + offset : nullptr, count);

                                     const auto velocities = outputs + modes->actuators();
                                     const auto asked = standard.lags ? velocities + probes : outputs;
                                     writeVoltages (block, offset, count, asked);
                                     writeMonitor (block, offset, count, velocities);
                                     noteVoltages (count, asked, meters);
                                     noteProbes (count, velocities, meters, trace);
                                 });
    const auto triggered = voices.counters().triggered;
    meters.addTriggered (triggered - std::exchange (countedTriggers, triggered));
    meters.noteState (standard.limiterNode().limiter().isMuted(), voices.activeVoices());
}

template <typename Sample>
void AudioPath::writeMonitor (const AudioBlock<Sample>& block, int offset, int count, Outputs velocities) const
{
    for (std::size_t i = 0; i < block.monitor.size(); ++i)
        if (i < probes)
            std::transform (velocities[i], velocities[i] + count, block.monitor[i] + offset,
                            [this] (double velocity) { return static_cast<Sample> (velocity * monitorGain); });
        else
            std::fill_n (block.monitor[i] + offset, count, Sample (0));
}

void AudioPath::noteProbes (int count, Outputs velocities, LevelMeters& meters, ProbeTrace& trace) const
{
    for (int i = 0; i < probes; ++i)
        meters.noteProbe (i, static_cast<float> (absolutePeak (velocities[i], count)));

    trace.write (velocities[0], count);
}

template void AudioPath::process (const AudioBlock<float>&, std::span<const FocusEvent>, const PlayControls&,
                                  LevelMeters&, ProbeTrace&);
template void AudioPath::process (const AudioBlock<double>&, std::span<const FocusEvent>, const PlayControls&,
                                  LevelMeters&, ProbeTrace&);
} // namespace antinode
