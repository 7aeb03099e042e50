#include "ModalError.h"

#include "LineSegment.h"

#include <antinode_base/Watch.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace antinode
{
namespace
{
/** The fit of i omega (c_-1 x^-2 + c_0 + c_1 x^2), real c, x = omega over the highest one, to what is left of each
    channel: normal equations of the channels, which differ by the lines that they lack. */
class ShareFit
{
public:
    ShareFit (const PreparedResponses& data, const IdentifiedModes& modesToUse)
        : modes (modesToUse), rows (data.points()), highest (data.omega[data.lines() - 1]),
          last (data.omega[0] + lowerPart * (highest - data.omega[0])),
          matrices (static_cast<std::size_t> (data.columns()), Eigen::Matrix3d::Zero()),
          sums (Eigen::Matrix3Xd::Zero (3, data.columns()))
    {
    }

    void add (Eigen::Index point, Eigen::Index reference, double omega, std::complex<double> left)
    {
        if (omega > last)
            return;

        const auto lowPass = modes.lowPasses.size() > 0 ? modes.lowPasses (point, reference) : 0.0;
        const auto value = left * std::polar (1.0, omega * modes.delay) * std::complex<double> (1, omega * lowPass);
        const auto x = std::pow (omega / highest, 2);
        const Eigen::Vector3d functions = omega * Eigen::Vector3d (1 / x, 1, x);
        const auto channel = point + rows * reference;
        matrices[static_cast<std::size_t> (channel)] += functions * functions.transpose();
        sums.col (channel) += value.imag() * functions;
    }

    Eigen::MatrixXd share() const
    {
        Eigen::MatrixXd result (rows, sums.cols() / rows);

        for (Eigen::Index channel = 0; channel < sums.cols(); ++channel)
        {
            const auto& matrix = matrices[static_cast<std::size_t> (channel)];
            const Eigen::FullPivLU<Eigen::Matrix3d> factors (matrix);
            result.reshaped()[channel] = factors.isInvertible() ? factors.solve (sums.col (channel))[1]
                                                                : std::numeric_limits<double>::quiet_NaN();
        }

        return result;
    }

private:
    static constexpr double lowerPart = 0.6; // Nearer to the next mode more terms would be needed.

    const IdentifiedModes& modes;
    Eigen::Index rows;
    double highest, last; // rad/s
    std::vector<Eigen::Matrix3d> matrices;
    Eigen::Matrix3Xd sums;
};
} // namespace

ModalRest modalRest (const IdentifiedModes& modes, const PreparedResponses& data)
{
    auto alone = modes;
    alone.residuals.clear();
    double error = 0, energy = 0;
    ShareFit fit (data, modes);

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
                    if (const auto left = measured (f, p) - given.values[i](f, p); std::isfinite (std::norm (left)))
                    {
                        error += std::norm (left);
                        energy += std::norm (measured (f, p));
                        fit.add (p, static_cast<Eigen::Index> (i), data.omega[first + f], left);
                    }
        }
    }

    return { 10 * std::log10 (std::max (error / energy, 1e-32)), fit.share() };
}
} // namespace antinode
