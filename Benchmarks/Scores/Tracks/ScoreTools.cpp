#include "ScoreTools.h"

#include <antinode_documents/Inputs.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_numerics/Statistics.h>
#include <antinode_render/PlayedTracks.h>

#include <cmath>

namespace antinode::scores
{
namespace
{
constexpr double unlimited = 1e5; // V
}

void setLimit (ModalModel& model, double volts)
{
    model.fullScaleVoltage = volts;

    for (auto& ceramic : model.ceramics)
    {
        ceramic.voltageLimit = volts;
        ceramic.amplifierVoltage = volts;
        ceramic.slewLimit = 0;
    }
}

Device deviceNamed (const std::string& name)
{
    const auto description = loadDevice (name, {});
    Device device { name, solveDeviceWithStaticShare (description, {}, true), {} };
    const auto modes = 3 * (device.known.modes() - device.known.actuators()) / 2;
    device.judge =
        solveDeviceWithStaticShare (description, static_cast<int> (std::min<Eigen::Index> (500, modes)), true);
    setLimit (device.known, unlimited);
    return device;
}

TrackSignal signalNamed (const std::string& name, int seed)
{
    if (name == "click")
        return ClickSignal {};

    if (name == "Gabor")
        return GaborSignal {};

    if (name == "AM")
        return ToneSignal { 250, 0.3, 0.02, 25, 1 };

    return NoiseSignal { 0.3, 0.02, static_cast<std::uint64_t> (seed) };
}

WaveformsDescription layout (const Surface& surface, int count, const std::string& signal, int seed)
{
    RandomNumbers random (static_cast<std::uint64_t> (seed));
    std::vector<TouchedPoint> points;

    while (static_cast<int> (points.size()) < count)
    {
        TouchedPoint point;
        point.x = surface.xMinimum + (surface.xMaximum - surface.xMinimum) * (0.1 + 0.8 * random.uniform());
        point.y = surface.yMinimum + (surface.yMaximum - surface.yMinimum) * (0.1 + 0.8 * random.uniform());

        if (std::all_of (points.begin(), points.end(),
                         [&] (const auto& other)
                         { return std::hypot (point.x - other.x, point.y - other.y) >= 0.025; }))
            points.push_back (point);
    }

    WaveformsDescription description;
    auto& track = description.tracks.emplace_back();
    track.point = points.front();
    track.events[0].signal = signalNamed (signal, seed);
    description.silent.assign (points.begin() + 1, points.end());
    return description;
}

TrackSettings usualSettings()
{
    TrackSettings settings;
    settings.threshold = findSkinThreshold ("");
    return settings;
}

double worstBystander (const TrackScores& scores, double (TrackScores::*suppression) (std::size_t) const)
{
    double worst = -300;

    for (std::size_t p = 1; p < scores.fingers.size(); ++p)
        worst = std::max (worst, (scores.*suppression) (p));

    return worst;
}

TrackScores judged (const ModalModel& judge, const TrackDesign& design)
{
    const auto played = playTracks (judge, design.description, design.voltages, ringing);
    return scoreTracks (played, design.wanted, design.description.band);
}
} // namespace antinode::scores
