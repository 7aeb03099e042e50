#include "ScoreTools.h"

#include <antinode_numerics/Statistics.h>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace antinode::scores
{
namespace
{
constexpr double speed = 0.1, way = 0.05; // m/s, m
} // namespace

WaveformsDescription movingLayout (const Surface& surface, int count, const std::string& signal, int seed)
{
    for (int attempt = 0;; ++attempt)
    {
        auto description = layout (surface, count, signal, seed + 1000 * attempt);
        RandomNumbers random (static_cast<std::uint64_t> (seed));
        auto& target = description.tracks[0].point;

        for (int turn = 0; turn < 20; ++turn)
        {
            const auto angle = 2 * std::numbers::pi * random.uniform();
            const auto x = target.x + way * std::cos (angle), y = target.y + way * std::sin (angle);
            target.path = { { 0, target.x, target.y }, { way / speed, x, y } };
            auto clear =
                std::abs (x - (surface.xMinimum + surface.xMaximum) / 2) < 0.4 * (surface.xMaximum - surface.xMinimum)
                && std::abs (y - (surface.yMinimum + surface.yMaximum) / 2)
                       < 0.4 * (surface.yMaximum - surface.yMinimum);

            for (double time = 0; time <= way / speed; time += 0.01)
                for (const auto& other : description.silent)
                    clear =
                        clear
                        && std::hypot (placeAt (target, time).x - other.x, placeAt (target, time).y - other.y) >= 0.025;

            if (clear)
            {
                auto& sound = description.tracks[0].events[0].signal;

                if (signal == "AM")
                    std::get<ToneSignal> (sound).duration = way / speed;
                else
                    std::get<NoiseSignal> (sound).duration = way / speed;

                return description;
            }
        }
    }
}

void movingTable (const Device& device, int layouts)
{
    for (const auto count : { 2, 3, 5 })
        for (const std::string signal : { "AM", "music" })
        {
            Spread volts, target, band, wide, iterations;

            for (int seed = 1; seed <= layouts; ++seed)
            {
                const auto description = movingLayout (device.known.surface, count, signal, seed);
                const auto design = designTracks (device.known, description, usualSettings());
                const auto scores = judged (device.judge, design);
                volts.values.push_back (design.peaks.maxCoeff());
                target.values.push_back (scores.suppression (0));
                band.values.push_back (worstBystander (scores, &TrackScores::suppression));
                wide.values.push_back (worstBystander (scores, &TrackScores::wideSuppression));
                iterations.values.push_back (design.iterations);
            }

            std::printf ("| %s | %d | %s | %.0f / %.0f | %.0f / %.0f | %.0f / %.0f | %.0f / %.0f | %.0f / %.0f |\n",
                         device.name.c_str(), count, signal.c_str(), volts.middle(), volts.worst(), target.middle(),
                         target.worst(), band.middle(), band.worst(), wide.middle(), wide.worst(), iterations.middle(),
                         iterations.worst());
            std::fflush (stdout);
        }
}
} // namespace antinode::scores
