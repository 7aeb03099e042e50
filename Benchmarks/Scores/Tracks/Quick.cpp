#include "ScoreTools.h"

#include <antinode_fingers/LoadedModel.h>
#include <antinode_tracks/FilterDesign.h>
#include <antinode_tracks/FilterPlayer.h>
#include <antinode_tracks/LiveTracks.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <deque>
#include <functional>

namespace antinode::scores
{
namespace
{
/** Seconds of the processor. */
double cpuOf (const std::function<void()>& work)
{
    const auto begin = std::clock();
    work();
    return static_cast<double> (std::clock() - begin) / CLOCKS_PER_SEC;
}

FilterSettings settingsFor (double latency)
{
    FilterSettings settings;
    settings.latency = latency;
    return settings;
}

QuickFilterDesigner designerOf (const Device& device, double latency = FilterSettings().latency)
{
    return { std::make_shared<const ModalModel> (device.known), TrackBand {}, settingsFor (latency) };
}

/** Every point a track of its own: what an instrument needs. */
WaveformsDescription asTracks (WaveformsDescription description)
{
    for (auto& point : description.silent)
    {
        auto& track = description.tracks.emplace_back (description.tracks[0]);
        track.point = point;
    }

    description.silent.clear();
    return description;
}

/** Filters of all points for the layout that has one track. */
FingerFilters firstOf (FingerFilters filters)
{
    filters.taps.resize (1);
    return filters;
}

/** A surface with the fingers on it that load it, as complex modes: filters know them as terms of rank one. */
ModalModel underFingers (const ModalModel& model, const WaveformsDescription& description)
{
    const auto fingers = restingFingers (description);
    return fingers.empty() ? model : loadedModel (model, fingers);
}

struct Found
{
    Spread volts, band, error, milliseconds;

    void add (const Device& device, const WaveformsDescription& description, const FingerFilters& filters, double cpu)
    {
        const auto design = liveTracks (device.known, description, usualSettings(), firstOf (filters));
        const auto scores = judged (underFingers (device.judge, description), design);
        volts.values.push_back (design.peaks.maxCoeff());
        band.values.push_back (worstBystander (scores, &TrackScores::suppression));
        error.values.push_back (scores.suppression (0));
        milliseconds.values.push_back (1e3 * cpu);
    }

    void print() const
    {
        std::printf (" %.0f / %.0f | %.0f / %.0f | %.0f / %.0f | %.1f / %.1f |", volts.middle(), volts.worst(),
                     band.middle(), band.worst(), error.middle(), error.worst(), milliseconds.middle(),
                     milliseconds.worst());
    }
};

/** Voltages of inputs at a place that moves: every so many seconds a bank for the place then, or what it was before,
    fades in. */
TrackDesign movingDesign (const Device& device, const QuickFilterDesigner& designer,
                          const WaveformsDescription& description, double interval, double age, Spread& milliseconds)
{
    const auto settings = usualSettings();
    TrackDesign design;
    design.description = description;
    design.wanted = wantedAsPlayed (device.known, description, settings);
    FingerFilters filters;
    const auto designAt = [&] (double time)
    {
        milliseconds.values.push_back (
            1e3 * cpuOf ([&] { filters = designer.design (asTracks (stillAt (description, time))); }));
    };
    designAt (0);
    std::deque<FilterBank> banks { filterBank (firstOf (filters)) };
    const auto fade = std::llround (interval * filters.rate());
    FilterPlayer player (banks.back(), fade);
    const auto each = fade * filters.factor;
    Eigen::MatrixXf voltages (device.known.actuators(), design.wanted.rows() + 2 * banks.back().taps * filters.factor);
    Eigen::VectorXf input (1);

    for (Eigen::Index n = 0; n < voltages.cols(); ++n)
    {
        if (n % each == 0)
        {
            designAt (static_cast<double> (n + each) / settings.sampleRate - filters.latency() - age);
            banks.push_back (filterBank (firstOf (filters)));
            player.fadeTo (banks.back());

            while (banks.size() > 3)
                banks.pop_front();
        }

        input[0] = n < design.wanted.rows() ? static_cast<float> (design.wanted (n, 0)) : 0;
        player.process (input, voltages.col (n));
    }

    design.voltages = { { Reconstruction::bandLimited, settings.sampleRate },
                        -filters.latency(),
                        voltages.cast<double>() };
    design.peaks = design.voltages.values.cwiseAbs().rowwise().maxCoeff();
    return design;
}

/** A layout with the filters of least error, and with quick ones. */
void addBoth (const Device& device, const QuickFilterDesigner& designer, const WaveformsDescription& description,
              double latency, Found& full, Found& quick)
{
    const auto all = asTracks (description);
    FingerFilters filters;
    const auto fullTime = cpuOf ([&] { filters = designFingerFilters (device.known, all, settingsFor (latency)); });
    full.add (device, description, filters, fullTime);
    const auto quickTime = cpuOf ([&] { filters = designer.design (all); });
    quick.add (device, description, filters, quickTime);
}

/** One row for each number of points. */
void quickRows (const Device& device, int layouts, double latency, const std::string& signal)
{
    const auto designer = designerOf (device, latency);

    for (const auto count : { 2, 3, 5 })
    {
        Found full, quick;

        for (int seed = 1; seed <= layouts; ++seed)
            addBoth (device, designer, layout (device.known.surface, count, signal, seed), latency, full, quick);

        std::printf ("| %s | %.0f | %d | %s |", device.name.c_str(), 1e3 * latency, count, signal.c_str());
        full.print();
        quick.print();
        std::printf ("\n");
        std::fflush (stdout);
    }
}

/** The same fingers as built-in ones that load the surface; "": they do not. */
WaveformsDescription under (WaveformsDescription description, const std::string& kind)
{
    const auto rest = [&kind] (TouchedPoint& point)
    {
        if (! kind.empty())
            point.finger = builtInFinger (kind, point.x, point.y);
    };
    rest (description.tracks[0].point);

    for (auto& point : description.silent)
        rest (point);

    return description;
}
} // namespace

void liveMusicTable (const Device& device, int layouts)
{
    for (const auto latency : { 0.02, 0.01 })
    {
        const auto designer = designerOf (device, latency);

        for (const std::string kind : { "", "medium" })
            for (const auto count : { 2, 3, 4, 5 })
            {
                std::printf ("| %s | %.0f | %d | %s |", device.name.c_str(), 1e3 * latency, count,
                             kind.empty() ? "none" : kind.c_str());
                Found full, quick;

                for (int seed = 1; seed <= layouts; ++seed)
                {
                    const auto description = under (layout (device.known.surface, count, "music", seed), kind);
                    addBoth (device, designer, description, latency, full, quick);
                }

                full.print();
                quick.print();
                std::printf ("\n");
                std::fflush (stdout);
            }
    }
}

void quickTable (const Device& device, int layouts)
{
    for (const std::string signal : { "click", "Gabor", "music" })
        quickRows (device, layouts, 0.02, signal);

    for (const auto latency : { 0.01, 0.005 })
        quickRows (device, layouts, latency, "music");
}

void movingLiveTable (const Device& device, int layouts)
{
    const auto designer = designerOf (device);

    for (const auto& [interval, age] : { std::pair { 0.005, 0.0 }, { 0.01, 0.0 }, { 0.01, 0.02 }, { 0.01, -0.005 } })
        for (const auto count : { 2, 3, 5 })
            for (const std::string signal : { "AM", "music" })
            {
                Spread volts, target, band, milliseconds;

                for (int seed = 1; seed <= layouts; ++seed)
                {
                    const auto description = movingLayout (device.known.surface, count, signal, seed);
                    const auto design = movingDesign (device, designer, description, interval, age, milliseconds);
                    const auto scores = judged (device.judge, design);
                    volts.values.push_back (design.peaks.maxCoeff());
                    target.values.push_back (scores.suppression (0));
                    band.values.push_back (worstBystander (scores, &TrackScores::suppression));
                }

                std::printf ("| %s | %.0f | %.0f | %d | %s | %.0f / %.0f | %.0f / %.0f | %.0f / %.0f | %.1f / %.1f |\n",
                             device.name.c_str(), 1e3 * interval, 1e3 * age, count, signal.c_str(), volts.middle(),
                             volts.worst(), target.middle(), target.worst(), band.middle(), band.worst(),
                             milliseconds.middle(), milliseconds.worst());
                std::fflush (stdout);
            }
}
} // namespace antinode::scores
