#include "Statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace antinode
{
double median (std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t> (values.size() / 2);
    std::nth_element (values.begin(), middle, values.end());
    return *middle;
}

double RandomNumbers::uniform()
{
    return static_cast<double> (engine() >> 11) * 0x1p-53;
}

Eigen::VectorXd RandomNumbers::normal (Eigen::Index count)
{
    Eigen::VectorXd numbers (count);

    for (Eigen::Index i = 0; i < count; i += 2)
    {
        const auto radius = std::sqrt (-2 * std::log (1 - uniform()));
        const auto angle = 2 * std::numbers::pi * uniform();
        numbers[i] = radius * std::cos (angle);

        if (i + 1 < count)
            numbers[i + 1] = radius * std::sin (angle);
    }

    return numbers;
}

void RandomNumbers::skipNormal (Eigen::Index count, Eigen::Index calls)
{
    const auto perCall = (count + 1) / 2 * 2; // Two of the engine's for every two of the normal distribution.
    engine.discard (static_cast<unsigned long long> (perCall) * static_cast<unsigned long long> (calls));
}
} // namespace antinode
