#include "ComplexModes.h"

#include <cmath>

namespace antinode
{
namespace
{
/** The strongest product in a table of complex residues, its shape turned to the real axis and as long as the real one. */
void splitResidues (IdentifiedModes& modes, Eigen::Index mode, const Eigen::MatrixXcd& table)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> eigen (table.adjoint() * table);
    const Eigen::VectorXcd direction = eigen.eigenvectors().rightCols (1);
    Eigen::VectorXcd shape = table * direction;
    const Eigen::VectorXd real = modes.shapes.col (mode).array().isFinite().select (modes.shapes.col (mode), 0);
    const auto squares = (shape.transpose() * shape) (0, 0);
    auto factor = std::polar (real.norm() / std::max (shape.norm(), 1e-300), -std::arg (squares) / 2);

    if ((shape * factor).real().dot (real) < 0)
        factor = -factor;

    modes.complexShapes.col (mode) = shape * factor;
    modes.complexParticipation.row (mode) = direction.adjoint() / factor;
}

/** Coefficients of the modes' functions: velocity and delay; together with a constant they are any complex residue. */
Eigen::MatrixXd functionAmplitudes (const IdentifiedModes& modes, const FitState& state)
{
    const auto points = modes.complexShapes.rows(), drivers = modes.complexParticipation.cols();
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (functionsOfMode * state.modes(), points * drivers);

    for (Eigen::Index k = 0; k < state.modes(); ++k)
    {
        const auto resonance = state.basis.angularFrequencies[k], damping = state.basis.dampingRatios[k];
        const Eigen::MatrixXcd products = modes.complexShapes.col (k) * modes.complexParticipation.row (k);
        const Eigen::RowVectorXcd flat = products.reshaped().transpose();
        const auto ofDelay = state.basis.column (k, ModalFunction::delay);
        result.row (ofDelay) = -flat.imag() / (resonance * std::sqrt (1 - damping * damping));
        result.row (state.basis.column (k, ModalFunction::velocity)) =
            flat.real() / resonance - damping * result.row (ofDelay);
    }

    return result;
}
} // namespace

void addComplexModes (IdentifiedModes& modes, const FitState& state, const Eigen::MatrixXcd& residues,
                      const PreparedResponses& data)
{
    const auto points = data.points(), drivers = data.drivers();
    modes.complexShapes.resize (points, state.modes());
    modes.complexParticipation.resize (state.modes(), drivers);

    for (Eigen::Index k = 0; k < state.modes(); ++k)
        splitResidues (modes, k, residues.row (k).reshaped (points, drivers));

    const auto amplitudesOfAll = functionAmplitudes (modes, state);
    auto coefficients = powerCoefficients (state.basis, state.products, amplitudesOfAll);
    modes.residuals.clear();

    for (std::size_t n = 0; n < state.basis.powers.size(); ++n)
    {
        const auto power = state.basis.powers[n];
        auto row = coefficients.row (static_cast<Eigen::Index> (n));

        // omega^2 / D tends to -1, residues alone to 0: the constant makes up for it.
        if (power == 0)
            for (Eigen::Index k = 0; k < state.modes(); ++k)
                row -= amplitudesOfAll.row (state.basis.column (k, ModalFunction::delay));

        modes.residuals.push_back ({ power, row.reshaped (points, drivers) / std::pow (state.basis.scale, power) });
    }
}
} // namespace antinode
