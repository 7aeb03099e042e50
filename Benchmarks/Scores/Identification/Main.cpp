// What is found in synthetic measurements, how long that takes, and what each warning of a mode is worth:
// Docs/Design/identification.md.
//
//     antinode_identification_scores SEED [measurements...]
//     antinode_identification_scores SEED deviations [NUMBER]
//
// Without names all are taken. A single one shows its memory. The second form gives errors over
// stated deviations, over so many measurements.

#include "Measurements.h"
#include "Support/DeviationScore.h"
#include "WarningScores.h"

#include <antinode_identification/Identification.h>

#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <span>

namespace
{
using namespace antinode;
using namespace antinode::test;

double processorTime()
{
    return static_cast<double> (std::clock()) / CLOCKS_PER_SEC;
}

double peakMegabytes()
{
    rusage usage {};
    getrusage (RUSAGE_SELF, &usage);
    return static_cast<double> (usage.ru_maxrss) / 1024;
}

double megabytes (const FrequencyResponses& responses)
{
    double bytes = 0;

    for (const auto& values : responses.values)
        bytes += sizeof (std::complex<double>) * static_cast<double> (values.size());

    return bytes / 1e6;
}

void run (const Measurement& measurement, WarningScores& warnings)
{
    const auto [truth, responses] = measurement.make();
    const auto before = peakMegabytes(), start = processorTime();
    const auto modes = identify (responses, {});
    const auto seconds = processorTime() - start;
    const auto found = score (modes, truth);
    add (warnings, modes, truth);
    std::printf ("%-16s %7.1f %6d %6d %8.2f %9.3f %9.4f %8.2f %8.0f %8.0f\n", measurement.name.c_str(),
                 megabytes (responses), found.found, found.falseOnes, modes.reconstructionError,
                 1e6 * quantile (found.frequency, 0.5), 100 * quantile (found.damping, 0.5), seconds, before,
                 peakMegabytes());
    std::fflush (stdout);
}

void scoreAllDeviations (unsigned seed, unsigned number)
{
    std::printf ("%-16s %9s %9s %9s %9s %9s %6s\n", "", "frequency", "damping", "particip.", "shape", "delay", "lost");

    for (const auto ofNoise : { false, true })
        for (const auto& [name, disturbance] :
             { std::pair { "white noise", Disturbance {} }, std::pair { "drift 50 ppm", Disturbance { 50e-6, 0 } },
               std::pair { "drift 200 ppm", Disturbance { 200e-6, 0 } },
               std::pair { "misfit 3 %", Disturbance { 0, 0.03 } } })
        {
            const auto result = scoreDeviations (disturbance, seed + 1, number, ofNoise);
            std::printf ("%-16s", name);

            for (const auto error : result.errors)
                std::printf (" %9.2f", error);

            std::printf (" %6d%s\n", result.lost, ofNoise ? "  of noise alone" : "");
            std::fflush (stdout);
        }
}
} // namespace

int main (int count, char** given)
{
    const std::span<char*> words (given + 1, static_cast<std::size_t> (count - 1));
    const auto seed = words.empty() ? 0 : static_cast<unsigned> (std::strtoul (words[0], nullptr, 10));
    const auto names = words.empty() ? words : words.subspan (1);
    const auto isWanted = [names] (const Measurement& measurement)
    { return names.empty() || std::find (names.begin(), names.end(), measurement.name) != names.end(); };

    if (! names.empty() && std::string (names[0]) == "deviations")
    {
        scoreAllDeviations (seed, names.size() > 1 ? static_cast<unsigned> (std::strtoul (names[1], nullptr, 10)) : 20);
        return 0;
    }

    WarningScores warnings;
    std::printf ("%-16s %7s %6s %6s %8s %9s %9s %8s %8s %8s\n", "", "data MB", "found", "false", "dB", "f ppm",
                 "damping %", "CPU s", "MB then", "MB peak");

    for (const auto& measurement : measurements (seed))
        if (isWanted (measurement))
            run (measurement, warnings);

    print (warnings);
}
