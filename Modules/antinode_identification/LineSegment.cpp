#include "LineSegment.h"

#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr Eigen::Index nodes = 16;

Eigen::VectorXd chebyshevNodes (double centre, double halfWidth)
{
    Eigen::VectorXd result (nodes);

    for (Eigen::Index j = 0; j < nodes; ++j)
        result[j] = centre + halfWidth * std::cos (std::numbers::pi * (static_cast<double> (j) + 0.5) / nodes);

    return result;
}

/** Lagrange polynomials through the nodes, in barycentric form. */
Eigen::MatrixXd lagrange (const Eigen::VectorXd& omega, const Eigen::VectorXd& at)
{
    Eigen::MatrixXd result (omega.size(), nodes);

    for (Eigen::Index f = 0; f < omega.size(); ++f)
    {
        for (Eigen::Index j = 0; j < nodes; ++j)
        {
            const auto sign = j % 2 == 0 ? 1.0 : -1.0;
            const auto weight = sign * std::sin (std::numbers::pi * (static_cast<double> (j) + 0.5) / nodes);
            const auto distance = omega[f] - at[j];
            result (f, j) = weight / (distance == 0 ? 1e-300 : distance);
        }

        result.row (f) /= result.row (f).sum();
    }

    return result;
}

void appendColumns (std::vector<Eigen::Index>& list, Eigen::Index first, Eigen::Index count)
{
    for (Eigen::Index j = 0; j < count; ++j)
        list.push_back (first + j);
}
} // namespace

LineSegment lineSegment (const ModalBasis& basis, const Eigen::VectorXd& omega, const Eigen::VectorXd& roots)
{
    const auto centre = (omega[0] + omega[omega.size() - 1]) / 2, halfWidth = (omega[omega.size() - 1] - omega[0]) / 2;
    const auto nodesAt = chebyshevNodes (centre, halfWidth);
    std::vector<Eigen::Index> nearModes, farModes;
    LineSegment segment;

    for (Eigen::Index k = 0; k < basis.modes(); ++k)
    {
        const auto isFar = omega.size() >= 4 * nodes && std::abs (basis.angularFrequencies[k] - centre) > 3 * halfWidth
                           && centre > 2 * halfWidth;
        (isFar ? farModes : nearModes).push_back (k);
        appendColumns (isFar ? segment.far : segment.near, basis.functions * k, basis.functions);
    }

    const auto powers = static_cast<Eigen::Index> (basis.powers.size());
    appendColumns (segment.near, basis.modalColumns(), powers);
    Eigen::MatrixXcd near (omega.size(), static_cast<Eigen::Index> (segment.near.size()));
    Eigen::MatrixXcd far (nodes, static_cast<Eigen::Index> (segment.far.size()));

    for (std::size_t n = 0; n < nearModes.size(); ++n)
        near.middleCols (basis.functions * static_cast<Eigen::Index> (n), basis.functions) =
            evaluateModalFunctions (basis, nearModes[n], omega);

    for (std::size_t n = 0; n < farModes.size(); ++n)
        far.middleCols (basis.functions * static_cast<Eigen::Index> (n), basis.functions) =
            evaluateModalFunctions (basis, farModes[n], nodesAt);

    near.rightCols (powers) = evaluatePowers (basis, omega);
    segment.nearReal = roots.asDiagonal() * near.real();
    segment.nearImaginary = roots.asDiagonal() * near.imag();
    segment.farReal = far.real();
    segment.farImaginary = far.imag();

    if (! segment.far.empty())
        segment.interpolation = roots.asDiagonal() * lagrange (omega, nodesAt);

    return segment;
}
} // namespace antinode
