#include "GridPlaces.h"

namespace antinode
{
int placesForPhase (double phase, int fewest)
{
    constexpr double tolerance = 3e-5; // of the amplitude
    double error = 1;
    auto count = 0;

    // The error of interpolation through n places is about (phase / 4)^n / n!.
    while (error > tolerance || count < fewest)
        error *= phase / 4 / ++count;

    return count;
}
} // namespace antinode
