#include "ModalError.h"

#include "LineSegment.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
double modalError (const IdentifiedModes& modes, const PreparedResponses& data)
{
    auto alone = modes;
    alone.residuals.clear();
    double error = 0, energy = 0;

    // Part by part: what was measured may fill most of the memory.
    for (Eigen::Index first = 0; first < data.lines(); first += linesOfSegment)
    {
        checkWatch();
        const auto count = std::min (linesOfSegment, data.lines() - first);
        const auto given = synthesise (alone, data.omega.segment (first, count) / (2 * std::numbers::pi));

        for (std::size_t i = 0; i < given.values.size(); ++i)
        {
            const auto measured = data.responses->values[i].middleRows (data.firstLine + first, count);

            for (Eigen::Index p = 0; p < data.points(); ++p)
                for (Eigen::Index f = 0; f < count; ++f)
                    if (const auto left = std::norm (measured (f, p) - given.values[i](f, p)); std::isfinite (left))
                    {
                        error += left;
                        energy += std::norm (measured (f, p));
                    }
        }
    }

    return 10 * std::log10 (std::max (error / energy, 1e-32));
}
} // namespace antinode
