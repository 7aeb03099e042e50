// Waveforms at seeded points of the embedded plates, judged by a model of more modes than the design knows, in the time
// domain: Docs/Design/tracks.md, Docs/Results.md.
//
//     antinode_track_scores exact|limits|fingers|passes|bench-passes|moving|live|quick|live-music|moving-live [layouts
//     [devices...]]

#include "ScoreTools.h"

#include <antinode_tracks/LiveTracks.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace
{
using namespace antinode;
using namespace antinode::scores;

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

/** Tracks as inputs of filters, at three latencies. */
void liveTable (const Device& device, int layouts)
{
    for (const auto latency : { 0.005, 0.01, 0.02 })
        for (const auto count : { 2, 3, 5 })
            for (const std::string signal : { "click", "Gabor", "music" })
            {
                Spread volts, band, error, iterations, seconds;

                for (int seed = 1; seed <= layouts; ++seed)
                {
                    auto settings = usualSettings();
                    settings.latency = latency;
                    const auto begin = std::chrono::steady_clock::now();
                    const auto design =
                        designLiveTracks (device.known, layout (device.known.surface, count, signal, seed), settings);
                    seconds.values.push_back (
                        std::chrono::duration<double> (std::chrono::steady_clock::now() - begin).count());
                    const auto scores = judged (device.judge, design);
                    volts.values.push_back (design.peaks.maxCoeff());
                    band.values.push_back (worstBystander (scores, &TrackScores::suppression));
                    error.values.push_back (scores.normalisedError (0));
                    iterations.values.push_back (design.iterations);
                }

                std::printf ("| %s | %.0f | %d | %s | %.0f / %.0f | %.0f / %.0f | %.0e / %.0e | %.0f | %.1f |\n",
                             device.name.c_str(), 1e3 * latency, count, signal.c_str(), volts.middle(), volts.worst(),
                             band.middle(), band.worst(), error.middle(), error.worst(), iterations.middle(),
                             seconds.middle());
                std::fflush (stdout);
            }
}

} // namespace

int main (int count, char** arguments)
{
    const std::vector<std::string> given (arguments + 1, arguments + count);
    const auto table = given.empty() ? std::string ("exact") : given[0];
    const auto layouts = given.size() > 1 ? std::atoi (given[1].c_str()) : 20;
    std::vector<std::string> devices { "glass-148x210", "phone-bare", "aluminium-200x120" };

    if (given.size() > 2)
        devices.assign (given.begin() + 2, given.end());

    for (const auto& name : devices)
    {
        const auto device = deviceNamed (name);
        std::printf ("%s: %td modes, judged by %td to %.0f Hz\n", name.c_str(), device.known.modes(),
                     device.judge.modes(), device.judge.frequencyHz (device.judge.modes() - 1));

        if (table == "limits")
            limitsTable (device, layouts);
        else if (table == "live")
            liveTable (device, layouts);
        else if (table == "fingers")
            fingersTable (device, layouts);
        else if (table == "passes")
            passesTable (device, layouts, false);
        else if (table == "bench-passes")
            passesTable (device, layouts, true);
        else if (table == "moving")
            movingTable (device, layouts);
        else if (table == "quick")
            quickTable (device, layouts);
        else if (table == "live-music")
            liveMusicTable (device, layouts);
        else if (table == "moving-live")
            movingLiveTable (device, layouts);
        else
            exactTable (device, layouts);
    }
}
