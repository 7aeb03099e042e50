#include "LineSegment.h"

#include "ChebyshevNodes.h"

#include <cmath>

namespace antinode
{
namespace
{
void appendColumns (std::vector<Eigen::Index>& list, Eigen::Index first, Eigen::Index count)
{
    for (Eigen::Index j = 0; j < count; ++j)
        list.push_back (first + j);
}
} // namespace

LineSegment lineSegment (const ModalBasis& basis, const Eigen::VectorXd& omega)
{
    const auto centre = (omega[0] + omega[omega.size() - 1]) / 2, halfWidth = (omega[omega.size() - 1] - omega[0]) / 2;
    const auto nodesAt = chebyshevNodes (centre, halfWidth);
    std::vector<Eigen::Index> nearModes, farModes;
    LineSegment segment;

    for (Eigen::Index k = 0; k < basis.modes(); ++k)
    {
        const auto isFar = omega.size() >= fewLines && centre > 2 * halfWidth
                           && std::abs (basis.angularFrequencies[k] - centre) > smoothDistance * halfWidth;
        (isFar ? farModes : nearModes).push_back (k);
        appendColumns (isFar ? segment.far : segment.near, basis.functions * k, basis.functions);
    }

    const auto powers = static_cast<Eigen::Index> (basis.powers.size());
    appendColumns (segment.near, basis.modalColumns(), powers);
    Eigen::MatrixXcd near (omega.size(), static_cast<Eigen::Index> (segment.near.size()));
    Eigen::MatrixXcd far (smoothNodes, static_cast<Eigen::Index> (segment.far.size()));

    for (std::size_t n = 0; n < nearModes.size(); ++n)
        near.middleCols (basis.functions * static_cast<Eigen::Index> (n), basis.functions) =
            evaluateModalFunctions (basis, nearModes[n], omega);

    for (std::size_t n = 0; n < farModes.size(); ++n)
        far.middleCols (basis.functions * static_cast<Eigen::Index> (n), basis.functions) =
            evaluateModalFunctions (basis, farModes[n], nodesAt);

    near.rightCols (powers) = evaluatePowers (basis, omega);
    segment.nearReal = near.real();
    segment.nearImaginary = near.imag();
    segment.farReal = far.real();
    segment.farImaginary = far.imag();

    if (! segment.far.empty())
        segment.interpolation = interpolation (omega, nodesAt);

    return segment;
}
} // namespace antinode
