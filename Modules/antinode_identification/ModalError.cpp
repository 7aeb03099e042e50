#include "ModalError.h"

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
    const auto given = synthesise (alone, data.omega / (2 * std::numbers::pi));
    double error = 0, energy = 0;

    for (Eigen::Index i = 0; i < data.references(); ++i)
    {
        const auto of = static_cast<std::size_t> (i);
        const auto measured = data.responses->values[of].middleRows (data.firstLine, data.lines());

        for (Eigen::Index p = 0; p < data.points(); ++p)
        {
            checkWatch();

            for (Eigen::Index f = 0; f < data.lines(); ++f)
                if (const auto left = std::norm (measured (f, p) - given.values[of](f, p)); std::isfinite (left))
                {
                    error += left;
                    energy += std::norm (measured (f, p));
                }
        }
    }

    return 10 * std::log10 (std::max (error / energy, 1e-32));
}
} // namespace antinode
