#include "PlateBench.h"

#include <antinode_documents/Inputs.h>
#include <antinode_documents/Library.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/Detuning.h>
#include <antinode_focus/SpillOver.h>
#include <antinode_model/ModalModel.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace antinode::test
{
namespace
{
constexpr DetuningSpread spread { 0.001, 0.05, 0.03, 0 };
constexpr std::uint64_t seed = 3;
constexpr double heardLevel = 0.25; // peak of what is heard of one focus, of full scale
constexpr double noiseLevel = 0.01, cubic = 0.01;
constexpr double silence = 0.01, margin = 0.005; // s before a trigger, s after a focus
constexpr float quiet = 1e-6F;

Eigen::MatrixXd currentShapes (const ModalModel& model, Eigen::Index idle)
{
    return model.participation.col (idle).transpose();
}

/** A device with all frequencies changed, and what its own focus reaches: as programs design, which know fewer modes.
 */
BenchDevice benchDevice (const BenchSetup& setup, double change, double rate)
{
    const auto description = loadDevice (setup.device, {});
    const auto known = solveDevice (description, {}, true).modes();
    BenchDevice device;
    device.model = detuned (solveDevice (description, static_cast<int> (3 * known / 2), true), spread, seed);
    device.model.angularFrequencies *= 1 + change;
    const auto driven = withoutDrive (device.model, { static_cast<int> (setup.idle) + 1 });
    const Playback playback { Reconstruction::bandLimited, rate };
    const auto focus = loadFocus (setup.focus, {});
    const auto design = designWithin ({ driven, known, {} }, focus, playback, DesignExtent::playable);
    const auto render =
        renderOffline (driven, design.program,
                       { playback, 2 * focus.focusTime + silence, 512, currentShapes (device.model, setup.idle) });
    device.wanted = render.focusVelocities;
    device.focusSample = render.focusSample;
    device.heardPeak = render.probeVelocities.cwiseAbs().maxCoeff();
    device.heardDeviation =
        render.probeVelocities.norm() / std::sqrt (static_cast<double> (render.probeVelocities.cols()));
    return device;
}
} // namespace

PlateBench::PlateBench (const BenchSetup& wanted, double sampleRate)
    : setup (wanted), rate (sampleRate), jumpSample (static_cast<std::size_t> (wanted.jumpTime * sampleRate)),
      delay (static_cast<std::size_t> (wanted.latency * sampleRate)), before (benchDevice (setup, setup.drift, rate)),
      after (benchDevice (setup, (1 + setup.drift) * (1 + setup.jump) - 1, rate)),
      voltages (static_cast<std::size_t> (before.model.actuators())), sources (voltages.size()),
      plate (before.model, rate, currentShapes (before.model, setup.idle)),
      jumped (after.model, rate, currentShapes (after.model, setup.idle))
{
    const auto length = static_cast<std::size_t> (setup.seconds * rate);

    for (auto& channel : voltages)
        channel.assign (length, 0);

    heard.assign (length, 0);
    const Eigen::VectorXd drawn = noiseLevel * before.heardDeviation * heardLevel / before.heardPeak
                                  * RandomNumbers (seed).normal (static_cast<Eigen::Index> (length));
    noise.assign (drawn.begin(), drawn.end());
}

bool PlateBench::process (const float* const* played, float* sensor, std::size_t count)
{
    std::fill_n (sensor, count, 0.0F);
    const auto isPlayed = [count] (const float* channel)
    { return std::any_of (channel, channel + count, [] (float sample) { return std::abs (sample) > quiet; }); };

    if (position == 0 && std::none_of (played, played + ceramics(), isPlayed))
        return true;

    const auto end = std::min (position + count, heard.size());

    for (std::size_t i = 0; i < ceramics(); ++i)
        std::copy_n (played[i], end - position, voltages[i].begin() + static_cast<std::ptrdiff_t> (position));

    const auto middle = std::clamp (jumpSample, position, end);
    move (position, middle);
    move (middle, end);
    hear (position, end);

    for (auto n = std::max (position, delay); n < end; ++n)
        sensor[n - position] = static_cast<float> (heard[n - delay]);

    position = end;
    return position < heard.size();
}

/** On one side of the jump. */
void PlateBench::move (std::size_t begin, std::size_t end)
{
    for (std::size_t i = 0; i < ceramics(); ++i)
        sources[i] = voltages[i].data() + begin;

    if (begin == jumpSample)
        jumped.copyMotion (plate);

    auto* const target = heard.data() + begin;
    (begin < jumpSample ? plate : jumped).process (sources.data(), &target, static_cast<int> (end - begin));
}

/** What the sensor makes of it. */
void PlateBench::hear (std::size_t begin, std::size_t end)
{
    const auto scale = before.model.fullScaleVoltage / before.heardPeak;

    for (auto n = begin; n < end; ++n)
    {
        const auto clean = scale * heard[n];
        const auto distorted = heardLevel * clean * (1 + cubic * clean * clean);
        heard[n] = std::clamp (distorted + noise[n], -1.0, 1.0);
    }
}

double PlateBench::peak() const
{
    double largest = 0;

    for (const auto& channel : voltages)
        for (const auto sample : channel)
            largest = std::max (largest, std::abs (sample));

    return largest;
}

/** The first samples after silence. */
std::vector<std::size_t> PlateBench::triggers() const
{
    std::vector<std::size_t> found;
    const auto least = static_cast<std::size_t> (silence * rate);

    for (std::size_t n = 0, quietSince = 0; n < heard.size(); ++n)
    {
        if (std::none_of (voltages.begin(), voltages.end(),
                          [n] (const auto& channel) { return std::abs (channel[n]) > quiet; }))
            continue;

        if (found.empty() || n - quietSince > least)
            found.push_back (n);

        quietSince = n;
    }

    return found;
}

std::vector<PlayedFocus> PlateBench::foci() const
{
    std::vector<PlayedFocus> all;
    const auto length = static_cast<std::size_t> (before.focusSample) + static_cast<std::size_t> (margin * rate);

    for (const auto trigger : triggers())
        if (trigger + length < heard.size() && (trigger >= jumpSample || trigger + length < jumpSample))
            all.push_back (evaluate (trigger));

    return all;
}

PlayedFocus PlateBench::evaluate (std::size_t trigger) const
{
    const auto& device = trigger < jumpSample ? before : after;
    PlateModel model (device.model, { Reconstruction::bandLimited, rate }, currentShapes (device.model, setup.idle));
    const auto length = device.focusSample + static_cast<Eigen::Index> (margin * rate);
    Eigen::MatrixXd volts (device.model.actuators(), length), velocities (device.model.modes(), length);

    for (Eigen::Index i = 0; i < volts.rows(); ++i)
        volts.row (i) =
            device.model.fullScaleVoltage
            * Eigen::Map<const Eigen::RowVectorXd> (voltages[static_cast<std::size_t> (i)].data() + trigger, length);

    model.processModes (volts, velocities);
    const auto least = (velocities.colwise() - device.wanted).colwise().norm().minCoeff();
    return { static_cast<double> (trigger) / rate, least / device.wanted.norm() };
}
} // namespace antinode::test
