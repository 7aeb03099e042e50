#include "OutlineScores.h"

#include <cstdio>
#include <cstdlib>

// Errors and processor time of the solver of outlined plates at random radii, ratios, positions, angles and Poisson's
// ratios, some minutes by hand: Docs/Results.md. Usage: antinode_outline_scores [CASES] [SEED]
using namespace antinode::scores;

int main (int argumentCount, char** arguments)
{
    const auto cases = argumentCount > 1 ? std::atoi (arguments[1]) : 20;
    const auto seed = argumentCount > 2 ? static_cast<unsigned> (std::atoi (arguments[2])) : 1;
    std::printf ("%-64s %6s %9s %9s %7s\n", "plates", "cases", "frequency", "particip.", "CPU s");

    for (const auto& score : { roundPlates (cases, seed, antinode::ModeAccuracy::usual),
                               roundPlates (cases, seed, antinode::ModeAccuracy::high), shiftedAndTurned (cases, seed),
                               plateaus (cases, seed), turnedSquares (cases, seed), reentrantCorners (cases, seed),
                               levyPlates (cases, seed), attachedPoints (cases, seed), eightPatches (seed, true),
                               eightPatches (seed, false) })
        std::printf ("%-64s %6d %9.1e %9.1e %7.2f %s\n", score.what, score.cases, score.frequencyError,
                     score.participationError, score.seconds, score.worst.c_str());
}
