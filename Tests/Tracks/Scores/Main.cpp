// The tables of Docs/Decisions/0073-a-waveform-per-finger.md: waveforms at seeded points of the embedded plates, judged
// by a model of more modes than the design knows, in the time domain.
//
//     antinode_track_scores exact|limits|fingers [layouts [devices...]]

#include <antinode_fingers/LoadedModel.h>
#include <antinode_library/Inputs.h>
#include <antinode_library/SkinThresholds.h>
#include <antinode_numerics/Median.h>
#include <antinode_numerics/RandomNumbers.h>
#include <antinode_render/TrackScores.h>
#include <antinode_tracks/TrackDesign.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace
{
using namespace antinode;

constexpr double unlimited = 1e5; // V

/** Numbers of many layouts: the median and the worst. */
struct Spread
{
    std::vector<double> values;

    double middle() const { return median (values); }
    double worst() const { return *std::max_element (values.begin(), values.end()); }
};

struct Device
{
    std::string name;
    ModalModel known, judge;
};

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

/** One track of 5 um and silence at other points, at least 25 mm apart. */
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
    track.signal = signalNamed (signal, seed);
    description.silent.assign (points.begin() + 1, points.end());
    return description;
}

TrackSettings usualSettings()
{
    TrackSettings settings;
    settings.threshold = findSkinThreshold ("");
    return settings;
}

/** The suppression at the worst bystander, within the band or of all frequencies. */
double worstBystander (const TrackScores& scores, double (TrackScores::*suppression) (std::size_t) const)
{
    double worst = -300;

    for (std::size_t p = 1; p < scores.fingers.size(); ++p)
        worst = std::max (worst, (scores.*suppression) (p));

    return worst;
}

TrackScores judged (const ModalModel& judge, const TrackDesign& design)
{
    const auto played = playTracks (judge, touchedShapes (judge, design.description), design.voltages, 0.3);
    return scoreTracks (played, design.wanted, design.description.band);
}

void exactTable (const Device& device, int layouts)
{
    for (const auto count : { 2, 3, 5 })
        for (const std::string signal : { "click", "Gabor", "AM", "music" })
        {
            Spread volts, band, wide, error;

            for (int seed = 1; seed <= layouts; ++seed)
            {
                const auto design =
                    designTracks (device.known, layout (device.known.surface, count, signal, seed), usualSettings());
                const auto scores = judged (device.judge, design);
                volts.values.push_back (design.peaks.maxCoeff());
                band.values.push_back (worstBystander (scores, &TrackScores::suppression));
                wide.values.push_back (worstBystander (scores, &TrackScores::wideSuppression));
                error.values.push_back (scores.normalisedError (0));
            }

            std::printf ("| %s | %d | %s | %.0f / %.0f | %.0f / %.0f | %.0f / %.0f | %.0e / %.0e |\n",
                         device.name.c_str(), count, signal.c_str(), volts.middle(), volts.worst(), band.middle(),
                         band.worst(), wide.middle(), wide.worst(), error.middle(), error.worst());
            std::fflush (stdout);
        }
}

/** Limits that no voltages keep: the share of the level that can be reached says the volts that all of it needs. */
void limitsTable (const Device& device, int layouts)
{
    constexpr double tightened = 100;

    for (const auto count : { 2, 3, 5 })
        for (const std::string signal : { "click", "Gabor", "AM", "music" })
        {
            Spread peaks, bounds, gaps, seconds;

            for (int seed = 1; seed <= layouts; ++seed)
            {
                const auto description = layout (device.known.surface, count, signal, seed);
                const auto free = designTracks (device.known, description, usualSettings()).peaks.maxCoeff();
                auto limited = device.known;
                setLimit (limited, free / tightened);
                const auto begin = std::chrono::steady_clock::now();

                try
                {
                    designTracks (limited, description, usualSettings());
                }
                catch (const TrackLimitError& error)
                {
                    peaks.values.push_back (1 / tightened / error.share);
                    bounds.values.push_back (error.bound / tightened / error.share);
                    gaps.values.push_back (1 / error.bound);
                }

                seconds.values.push_back (
                    std::chrono::duration<double> (std::chrono::steady_clock::now() - begin).count());
            }

            std::printf ("| %s | %d | %s | %.2f / %.2f | %.2f / %.2f | %.2f / %.2f | %.0f / %.0f |\n",
                         device.name.c_str(), count, signal.c_str(), peaks.middle(), peaks.worst(), bounds.middle(),
                         bounds.worst(), gaps.middle(), gaps.worst(), seconds.middle(), seconds.worst());
            std::fflush (stdout);
        }
}

/** The suppression of a design for some fingers on the surface with others. */
double withFingers (const Device& device, WaveformsDescription description, const std::vector<Finger>& designed,
                    const std::vector<Finger>& real)
{
    if (! designed.empty())
        description.tracks[0].point.finger = designed[0];

    for (std::size_t p = 1; p < designed.size(); ++p)
        description.silent[p - 1].finger = designed[p];

    const auto design = designTracks (device.known, description, usualSettings());
    return worstBystander (judged (loadedModel (device.judge, real), design), &TrackScores::suppression);
}

/** Fingers that differ from a nominal one by +-50 % in each property and +-3 mm, evenly. */
void fingersTable (const Device& device, int layouts)
{
    Spread ignored, nominal, known;

    for (int seed = 1; seed <= layouts; ++seed)
    {
        const auto description = layout (device.known.surface, 3, "Gabor", seed);
        RandomNumbers random (static_cast<std::uint64_t> (1000 + seed));
        const auto about = [&] (double value) { return value * (0.5 + random.uniform()); };
        std::vector<Finger> same, real;

        for (const auto& point : touchedPoints (description))
        {
            same.push_back (builtInFinger ("medium", point.x, point.y));
            auto finger = same.back();
            finger.mass = about (finger.mass);
            finger.damping = about (finger.damping);
            finger.stiffness = about (finger.stiffness);
            finger.x += 0.003 * (2 * random.uniform() - 1);
            finger.y += 0.003 * (2 * random.uniform() - 1);
            real.push_back (finger);
        }

        ignored.values.push_back (withFingers (device, description, {}, real));
        nominal.values.push_back (withFingers (device, description, same, real));
        known.values.push_back (withFingers (device, description, same, same));
    }

    std::printf ("| %s | %.0f / %.0f | %.0f / %.0f | %.0f / %.0f |\n", device.name.c_str(), ignored.middle(),
                 ignored.worst(), nominal.middle(), nominal.worst(), known.middle(), known.worst());
}
} // namespace

int main (int count, char** arguments)
{
    const std::vector<std::string> given (arguments + 1, arguments + count);
    const auto table = given.empty() ? std::string ("exact") : given[0];
    const auto layouts = given.size() > 1 ? std::atoi (given[1].c_str()) : 20;
    std::vector<std::string> devices { "glass-148x210", "phone", "aluminium-200x120" };

    if (given.size() > 2)
        devices.assign (given.begin() + 2, given.end());

    for (const auto& name : devices)
    {
        const auto device = deviceNamed (name);
        std::printf ("%s: %td modes, judged by %td to %.0f Hz\n", name.c_str(), device.known.modes(),
                     device.judge.modes(), device.judge.frequencyHz (device.judge.modes() - 1));

        if (table == "limits")
            limitsTable (device, layouts);
        else if (table == "fingers")
            fingersTable (device, layouts);
        else
            exactTable (device, layouts);
    }
}
