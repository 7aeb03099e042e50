#include "AudioPath.h"

#include "BlockPeak.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr int longestPart = 512;    // samples that are processed at once: few enough to stay in the cache
constexpr int longestOpenPart = 64; // the same where every oscillation has a channel

template <typename Sample>
void copyScaled (const double* from, Sample* to, int count, double gain)
{
    for (int n = 0; n < count; ++n)
        to[n] = static_cast<Sample> (from[n] * gain);
}
} // namespace

AudioPath::AudioPath (std::shared_ptr<const ModalModel> model, double sampleRateToUse,
                      const Eigen::MatrixXd& probeShapes, const GraphChoice& graph, Listening whoListens)
    : modes (std::move (model)), rate (sampleRateToUse),
      standard (graph.isOpen ? openGraph (modes, PlayerSettings {}, probeShapes, graph.insert)
                             : standardGraph (modes, PlayerSettings {}, probeShapes)),
      listening (std::move (whoListens)), toFullScale (1 / modes->fullScaleVoltage)
{
    standard.graph.prepare ({ rate, graph.isOpen ? longestOpenPart : longestPart });
    outputLimiter = standard.lags.limiterIn (standard.graph);
    designs = std::make_unique<DesignWorker> (standard.voiceNode().voices().handOver());
}

void AudioPath::setFocusLimits (const Eigen::VectorXd& volts)
{
    for (auto* const limiter : { &standard.limiterNode(), outputLimiter })
        if (limiter != nullptr)
            limiter->setFocusLimits (volts);
}

bool AudioPath::isSilentAfter (std::int64_t passed) const
{
    return static_cast<double> (passed) > 2 * LimiterNode::rampTime * rate;
}

template <typename Sample>
void AudioPath::process (const OutputBlock<Sample>& block, std::span<const FocusEvent> events,
                         const PlayControls& controls, LevelMeters& meters, ProbeTrace& trace)
{
    standard.voiceNode().voices().setSettings (controls.notes);
    standard.gainNode().setGain (controls.outputTrim);
    standard.gainNode().setMutes (controls.mutes | listening.idle);

    for (auto* const limiter : { &standard.limiterNode(), outputLimiter })
        if (limiter != nullptr)
        {
            limiter->setArmed (controls.isArmed);
            limiter->setVoltageLimit (controls.voltageLimit);
        }

    monitorGain = controls.monitorGain;
    standard.graph.processParts<double> (
        block.count, events,
        [&] (int offset, int count, Outputs outputs)
        {
            // Before its samples are written over.
            if (listening.tap != nullptr)
                listening.tap->write (outputs, block.sensor != nullptr ? block.sensor + offset : nullptr, count);

            write (block, offset, count, outputs);
            note (count, outputs, meters, trace);
        });
}

std::int64_t AudioPath::lateSamples()
{
    return standard.lags.lateSamples (standard.graph);
}

AudioPath::Outputs AudioPath::askedFor (Outputs outputs) const
{
    return standard.lags ? outputs + modes->actuators() + probes : outputs;
}

template <typename Sample>
void AudioPath::write (const OutputBlock<Sample>& block, int offset, int count, Outputs outputs) const
{
    const auto ceramics = static_cast<std::size_t> (modes->actuators());
    const auto* const asked = askedFor (outputs);

    for (std::size_t i = 0; i < block.ceramics.size(); ++i)
        if (i < ceramics)
            copyScaled (asked[i], block.ceramics[i] + offset, count, toFullScale);
        else
            std::fill_n (block.ceramics[i] + offset, count, Sample (0));

    for (std::size_t i = 0; i < block.monitor.size(); ++i)
        if (i < probes)
            copyScaled (outputs[ceramics + i], block.monitor[i] + offset, count, monitorGain);
        else
            std::fill_n (block.monitor[i] + offset, count, Sample (0));
}

void AudioPath::note (int count, Outputs outputs, LevelMeters& meters, ProbeTrace& trace)
{
    auto& limiter = standard.limiterNode();
    const auto* const asked = askedFor (outputs);
    const auto ceramics = static_cast<std::size_t> (modes->actuators());

    for (std::size_t i = 0; i < std::min<std::size_t> (ceramics, LevelMeters::ceramics); ++i)
    {
        meters.notePeak (static_cast<int> (i), static_cast<float> (absolutePeak (asked[i], count)));
        meters.addLimited (static_cast<int> (i),
                           limiter.takeLimitedSamples (i)
                               + (outputLimiter != nullptr ? outputLimiter->takeLimitedSamples (i) : 0));
    }

    for (std::size_t i = 0; i < probes; ++i)
        meters.noteProbe (static_cast<int> (i), static_cast<float> (absolutePeak (outputs[ceramics + i], count)));

    const auto& voices = standard.voiceNode().voices();
    const auto triggered = voices.counters().triggered;
    meters.addTriggered (triggered - std::exchange (countedTriggers, triggered));
    meters.noteState (limiter.limiter().isMuted(), voices.activeVoices());
    trace.write (outputs[ceramics], count);
}

template void AudioPath::process (const OutputBlock<float>&, std::span<const FocusEvent>, const PlayControls&,
                                  LevelMeters&, ProbeTrace&);
template void AudioPath::process (const OutputBlock<double>&, std::span<const FocusEvent>, const PlayControls&,
                                  LevelMeters&, ProbeTrace&);
} // namespace antinode
