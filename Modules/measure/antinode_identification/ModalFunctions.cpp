#include "ModalFunctions.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace antinode
{
Eigen::MatrixXcd evaluateModalFunctions (const ModalBasis& basis, Eigen::Index mode, const Eigen::VectorXd& omega)
{
    using std::complex;
    const auto resonance = basis.angularFrequencies[mode], damping = basis.dampingRatios[mode];
    Eigen::MatrixXcd result (omega.size(), basis.functions);

    for (Eigen::Index f = 0; f < omega.size(); ++f)
    {
        const complex<double> velocity (0, omega[f]);
        const complex<double> denominator ((resonance - omega[f]) * (resonance + omega[f]),
                                           2 * damping * resonance * omega[f]);
        const auto g = velocity * resonance / denominator;
        const auto byDenominator = -g / denominator;
        result (f, 0) = g;
        result (f, 1) = byDenominator * complex<double> (2 * resonance, 2 * damping * omega[f]) * damping * resonance;
        result (f, 2) = byDenominator * complex<double> (0, 2 * resonance * omega[f]) * damping;
        result (f, 3) = -velocity * g / resonance;

        for (Eigen::Index derivative = 1; derivative + 3 < basis.functions; ++derivative)
            result (f, derivative + 3) = -velocity * result (f, derivative) / resonance;
    }

    return result;
}

Eigen::MatrixXcd evaluatePowers (const ModalBasis& basis, const Eigen::VectorXd& omega)
{
    Eigen::MatrixXcd result (omega.size(), static_cast<Eigen::Index> (basis.powers.size()));

    for (Eigen::Index f = 0; f < omega.size(); ++f)
        for (std::size_t n = 0; n < basis.powers.size(); ++n)
            result (f, static_cast<Eigen::Index> (n)) =
                std::pow (std::complex<double> (0, omega[f] / basis.scale), basis.powers[n]);

    return result;
}

namespace
{
double nodeAngle (Eigen::Index node)
{
    return std::numbers::pi * (static_cast<double> (node) + 0.5) / static_cast<double> (smoothNodes);
}
} // namespace

Eigen::VectorXd chebyshevNodes (double centre, double halfWidth)
{
    Eigen::VectorXd result (smoothNodes);

    for (Eigen::Index j = 0; j < smoothNodes; ++j)
        result[j] = centre + halfWidth * std::cos (nodeAngle (j));

    return result;
}

Eigen::MatrixXd interpolation (const Eigen::VectorXd& at, const Eigen::VectorXd& nodes)
{
    Eigen::MatrixXd result (at.size(), smoothNodes);

    // Lagrange's polynomials in barycentric form.
    for (Eigen::Index f = 0; f < at.size(); ++f)
    {
        for (Eigen::Index j = 0; j < smoothNodes; ++j)
        {
            const auto weight = (j % 2 == 0 ? 1.0 : -1.0) * std::sin (nodeAngle (j));
            const auto distance = at[f] - nodes[j];
            result (f, j) = weight / (distance == 0 ? 1e-300 : distance);
        }

        result.row (f) /= result.row (f).sum();
    }

    return result;
}

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
