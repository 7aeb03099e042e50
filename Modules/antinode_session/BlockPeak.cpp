#include "BlockPeak.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
double absolutePeak (const double* samples, int count)
{
    double peak = 0;

    for (int n = 0; n < count; ++n)
        peak = std::max (peak, std::abs (samples[n]));

    return peak;
}
} // namespace antinode
