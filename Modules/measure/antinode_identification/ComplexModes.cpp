#include "ComplexModes.h"

#include <antinode_numerics/ComplexKernels.h>
#include <antinode_numerics/Decompositions.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace antinode
{
namespace
{
/** The strongest product in a table of complex residues, its shape turned to the real axis and as long as the real one.
 */
void splitResidues (IdentifiedModes& modes, Eigen::Index mode, const Eigen::MatrixXcd& table)
{
    const auto direction = largestEigenpair (adjointGram (table)).vector;
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
Eigen::MatrixXd functionAmplitudes (const IdentifiedModes& modes, const ModalBasis& basis)
{
    const auto points = modes.complexShapes.rows(), references = modes.complexParticipation.cols();
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (basis.modalColumns(), points * references);

    for (Eigen::Index k = 0; k < basis.modes(); ++k)
    {
        const auto resonance = basis.angularFrequencies[k], damping = basis.dampingRatios[k];
        const Eigen::MatrixXcd products = modes.complexShapes.col (k) * modes.complexParticipation.row (k);
        const Eigen::RowVectorXcd flat = products.reshaped().transpose();
        const auto ofDelay = basis.column (k, ModalFunction::delay);
        result.row (ofDelay) = -flat.imag() / (resonance * std::sqrt (1 - damping * damping));
        result.row (basis.column (k, ModalFunction::velocity)) =
            flat.real() / resonance - damping * result.row (ofDelay);
    }

    return result;
}

using Indices = std::vector<Eigen::Index>;
constexpr std::array values { ModalFunction::velocity, ModalFunction::delay };
/** By the unknown, frequency or damping, and the function of which they are derivatives. */
constexpr std::array<std::array<ModalFunction, 2>, 2> derivatives {
    { { ModalFunction::frequency, ModalFunction::delayFrequency },
      { ModalFunction::damping, ModalFunction::delayDamping } }
};

void appendColumns (Indices& to, const ModalBasis& basis, ModalFunction function)
{
    for (Eigen::Index k = 0; k < basis.modes(); ++k)
        to.push_back (basis.column (k, function));
}

ModalBasis stepped (ModalBasis basis, const Eigen::VectorXd& step)
{
    for (Eigen::Index k = 0; k < basis.modes(); ++k)
    {
        basis.angularFrequencies[k] *= 1 + basis.dampingRatios[k] * std::clamp (step[k], -1.0, 1.0);
        basis.dampingRatios[k] = std::clamp (
            basis.dampingRatios[k] * std::exp (std::clamp (step[basis.modes() + k], -0.7, 0.7)), 1e-9, 0.999);
    }

    return basis;
}
} // namespace

PoleEquations poleEquations (const ModalBasis& basis, const ModalProducts& products,
                             const Eigen::VectorXd& columnWeights, double ridge)
{
    const auto reduced = withoutPowers (basis, products);
    const auto modes = basis.modes();
    Indices linear, nonlinear;

    for (const auto function : values)
        appendColumns (linear, basis, function);

    for (const auto& ofUnknown : derivatives)
        for (const auto function : ofUnknown)
            appendColumns (nonlinear, basis, function);

    const auto between = Eigen::MatrixXd (reduced.gram (linear, nonlinear));
    const auto data = Eigen::MatrixXd (reduced.data (linear, Eigen::all));
    const auto coefficients = solveEven (reduced.gram (linear, linear), data, ridge);
    const Eigen::MatrixXd gram = reduced.gram (nonlinear, nonlinear)
                                 - between.transpose() * solveEven (reduced.gram (linear, linear), between, ridge);
    const Eigen::MatrixXd errors = reduced.data (nonlinear, Eigen::all) - between.transpose() * coefficients;
    const Eigen::MatrixXd weighted = coefficients * columnWeights.asDiagonal();
    const Eigen::MatrixXd pairs = weighted * coefficients.transpose();
    PoleEquations result {
        Eigen::MatrixXd::Zero (2 * modes, 2 * modes), Eigen::MatrixXd::Zero (2 * modes, products.data.cols()),
        (reduced.energies - data.cwiseProduct (coefficients).colwise().sum().transpose()).dot (columnWeights)
    };

    // The coefficients of the functions that an unknown changes multiply what it changes of them.
    for (Eigen::Index a = 0; a < 2; ++a)
        for (Eigen::Index u = 0; u < 2; ++u)
        {
            result.scores.middleRows (a * modes, modes) +=
                errors.middleRows ((2 * a + u) * modes, modes).cwiseProduct (weighted.middleRows (u * modes, modes));

            for (Eigen::Index b = 0; b < 2; ++b)
                for (Eigen::Index v = 0; v < 2; ++v)
                    result.matrix.block (a * modes, b * modes, modes, modes) +=
                        gram.block ((2 * a + u) * modes, (2 * b + v) * modes, modes, modes)
                            .cwiseProduct (pairs.block (u * modes, v * modes, modes, modes));
        }

    return result;
}

FreeResidues fitFreeResidues (const PreparedResponses& data, const NormalModes& start, double ridge)
{
    constexpr int maximumIterations = 12;
    constexpr int maximumHalvings = 6;
    constexpr double minimumGain = 1e-9; // relative, of the cost
    constexpr double negligible = 1e-7;  // the same, of what a step promises
    auto basis = makeBasis (start.angularFrequencies, start.dampingRatios, data);
    basis.functions = complexModeFunctions;
    const auto moments = lineMoments (data, start.delay);
    auto products = modalProducts (basis, data, moments, start.delay);
    auto equations = poleEquations (basis, products, data.columnWeights, ridge);

    auto isConverged = false;

    for (int iteration = 0; iteration < maximumIterations && ! isConverged; ++iteration)
    {
        const Eigen::VectorXd gradient = equations.scores.rowwise().sum();
        Eigen::VectorXd step = solveEven (equations.matrix, gradient, 1e-9);
        const auto promised = step.dot (gradient);
        auto isBetter = false;

        // Where poles are far from theirs, a whole step may lead away.
        for (int halved = 0; halved < maximumHalvings && ! isBetter && ! isConverged; ++halved, step *= 0.5)
        {
            const auto next = stepped (basis, step);
            auto nextProducts = modalProducts (next, data, moments, start.delay);
            auto nextEquations = poleEquations (next, nextProducts, data.columnWeights, ridge);
            isBetter = nextEquations.cost <= equations.cost * (1 - minimumGain);

            if (isBetter)
            {
                basis = next;
                products = std::move (nextProducts);
                equations = std::move (nextEquations);
            }
            else
                isConverged = promised <= negligible * equations.cost;
        }

        if (! isBetter)
            break;
    }

    auto residues = complexResidues (basis, products, ridge);
    return { std::move (basis), std::move (products), std::move (residues), isConverged };
}

FreeResidues freeResidues (const FitState& state, double ridge)
{
    return { state.basis, state.products, complexResidues (state.basis, state.products, ridge), true };
}

double freeCost (const FreeResidues& fit, const Eigen::VectorXd& columnWeights, double ridge)
{
    const auto reduced = withoutPowers (fit.basis, fit.products);
    Indices linear;

    for (const auto function : values)
        appendColumns (linear, fit.basis, function);

    const Eigen::MatrixXd data = reduced.data (linear, Eigen::all);
    const auto coefficients = solveEven (reduced.gram (linear, linear), data, ridge);
    return (reduced.energies - data.cwiseProduct (coefficients).colwise().sum().transpose()).dot (columnWeights);
}

Eigen::MatrixXd addComplexModes (IdentifiedModes& modes, const FreeResidues& fit, const PreparedResponses& data)
{
    const auto points = data.points(), references = data.references();
    const auto& basis = fit.basis;
    modes.complexShapes.resize (points, basis.modes());
    modes.complexParticipation.resize (basis.modes(), references);

    for (Eigen::Index k = 0; k < basis.modes(); ++k)
        splitResidues (modes, k, fit.residues.row (k).reshaped (points, references));

    const auto amplitudes = functionAmplitudes (modes, basis);
    Eigen::MatrixXd coefficients (basis.size(), data.columns());
    coefficients << amplitudes, powerCoefficients (basis, fit.products, amplitudes);
    modes.residuals.clear();

    for (std::size_t n = 0; n < basis.powers.size(); ++n)
    {
        const auto power = basis.powers[n];
        Eigen::RowVectorXd row = coefficients.row (basis.modalColumns() + static_cast<Eigen::Index> (n));

        // omega^2 / D tends to -1, residues alone to 0: the constant makes up for it.
        if (power == 0)
            for (Eigen::Index k = 0; k < basis.modes(); ++k)
                row -= amplitudes.row (basis.column (k, ModalFunction::delay));

        modes.residuals.push_back ({ power, row.reshaped (points, references) / std::pow (basis.scale, power) });
    }

    return coefficients;
}
} // namespace antinode
