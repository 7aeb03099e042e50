#pragma once

#include "DisturbedStructure.h"
#include "IdentificationScore.h"

#include <antinode_identification/Identification.h>

#include <array>

namespace antinode::test
{
/** RMS over modes and measurements of errors over stated deviations: of frequency, damping, participation, shape and
    delay. */
struct DeviationScore
{
    std::array<double, 5> errors {};
    int lost = 0; ///< Modes that were not found, or more than once.
};

/** Of a beam of five modes, 16 points and 3 ceramics, of which the modes are selected.
    @param first    number of the first measurement
    @param ofNoise  the deviations of noise alone */
inline DeviationScore scoreDeviations (const Disturbance& disturbance, unsigned first, unsigned measurements,
                                       bool ofNoise = false)
{
    const auto truth = lowestModes (knownBeam (5, 16, 3), 5);
    DeviationScore result;

    for (unsigned number = first; number < first + measurements; ++number)
    {
        IdentificationOptions options;
        options.complexModes = false;
        options.maximumOrder = 8; // enough to find them: what is measured is the fit
        options.pointMasses = truth.masses;
        options.selected.assign (truth.frequencies.begin(), truth.frequencies.end());
        auto modes =
            identify (disturbedResponses (truth, lines (200, 3000, 4), disturbance, independentSeed (number)), options);

        if (ofNoise)
            modes.deviations = modes.noiseDeviations;

        const auto found = score (modes, truth);
        const auto delay = (modes.delay - truth.delay) / modes.deviations.delay;
        const std::array all { found.zFrequency, found.zDamping, found.zParticipation, found.zShape, delay };
        result.lost += 5 - found.found + found.falseOnes;

        for (std::size_t n = 0; n < all.size(); ++n)
            result.errors[n] += all[n] * all[n] / measurements;
    }

    for (auto& error : result.errors)
        error = std::sqrt (error);

    return result;
}
} // namespace antinode::test
