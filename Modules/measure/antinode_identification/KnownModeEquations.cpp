#include "KnownModeEquations.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/GaussNewton.h>

#include <array>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double ridge = 1e-12; // relative: against rounding
constexpr std::array polesAndDelay { ModalFunction::frequency, ModalFunction::damping, ModalFunction::delay };

Eigen::MatrixXd productsOf (const KnownModeState& state, ModalFunction row, ModalFunction column)
{
    const auto modes = state.basis.modes();
    return state.reduced.gram (functionsOf (row, modes), functionsOf (column, modes));
}

/** How much the coefficient of a function changes with an unknown, per strength: a delay turns higher modes more. */
Eigen::VectorXd unitsOf (ModalFunction function, const KnownModes& modes, double delayUnit)
{
    return function == ModalFunction::delay ? Eigen::VectorXd (delayUnit * modes.angularFrequencies)
                                            : Eigen::VectorXd::Ones (modes.modes());
}

Eigen::Index columnsOfPoles (Eigen::Index modes)
{
    return 2 * modes + 1;
}

/** Adds a block of modes with modes where it belongs: the delay is one unknown of all modes. */
void place (Eigen::MatrixXd& to, const Eigen::MatrixXd& block, std::size_t column, Eigen::Index modes)
{
    if (polesAndDelay[column] == ModalFunction::delay)
        to.col (2 * modes) += block.rowwise().sum();
    else
        to.middleCols (static_cast<Eigen::Index> (column) * modes, modes) += block;
}

/** Of poles with each other, strengths as they are. */
Eigen::MatrixXd poleMatrix (const KnownModeState& state, const KnownModes& modes, const Eigen::MatrixXd& strengths,
                            double delayUnit)
{
    const auto count = modes.modes();
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero (count, count);

    for (std::size_t i = 0; i < state.shapes.size(); ++i)
    {
        const auto strength = strengths.col (static_cast<Eigen::Index> (i));
        products += state.shapes[i].cwiseProduct (strength * strength.transpose());
    }

    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (columnsOfPoles (count), columnsOfPoles (count));

    for (std::size_t a = 0; a < polesAndDelay.size(); ++a)
    {
        Eigen::MatrixXd rows = Eigen::MatrixXd::Zero (count, columnsOfPoles (count));
        const auto ofRows = unitsOf (polesAndDelay[a], modes, delayUnit);

        for (std::size_t b = 0; b < polesAndDelay.size(); ++b)
            place (rows,
                   ofRows.asDiagonal() * productsOf (state, polesAndDelay[a], polesAndDelay[b]).cwiseProduct (products)
                       * unitsOf (polesAndDelay[b], modes, delayUnit).asDiagonal(),
                   b, count);

        if (polesAndDelay[a] == ModalFunction::delay)
            result.row (2 * count) += rows.colwise().sum();
        else
            result.middleRows (static_cast<Eigen::Index> (a) * count, count) += rows;
    }

    return result;
}

Eigen::VectorXd poleGradient (const KnownModeState& state, const KnownModes& modes, const Eigen::MatrixXd& strengths,
                              double delayUnit)
{
    const auto count = modes.modes();
    const auto points = state.weightedShapes.cols() / strengths.cols();
    Eigen::MatrixXd amplitudes = state.weightedShapes;

    for (Eigen::Index i = 0; i < strengths.cols(); ++i)
        amplitudes.middleCols (i * points, points).array().colwise() *= strengths.col (i).array();

    Eigen::VectorXd result = Eigen::VectorXd::Zero (columnsOfPoles (count));

    for (std::size_t a = 0; a < polesAndDelay.size(); ++a)
    {
        const Eigen::VectorXd of = state.errors (functionsOf (polesAndDelay[a], count), Eigen::all)
                                       .cwiseProduct (amplitudes)
                                       .rowwise()
                                       .sum()
                                       .cwiseProduct (unitsOf (polesAndDelay[a], modes, delayUnit));

        if (polesAndDelay[a] == ModalFunction::delay)
            result[2 * count] = of.sum();
        else
            result.segment (static_cast<Eigen::Index> (a) * count, count) = of;
    }

    return result;
}

/** What was known before, of poles. */
void addPolePrior (KnownModeEquations& equations, const KnownModes& modes, const KnownModePrior& prior)
{
    for (Eigen::Index k = 0; k < modes.modes(); ++k)
    {
        const auto unit = modes.dampingRatios[k], spread = prior.frequencySpreads[k];
        const auto damping = modes.modes() + k;
        equations.poles (k, k) += (unit / spread) * (unit / spread);
        equations.gradient[k] -=
            unit * std::log (modes.angularFrequencies[k] / prior.angularFrequencies[k]) / (spread * spread);
        equations.poles (damping, damping) += 1 / (prior.dampingSpread * prior.dampingSpread);
        equations.gradient[damping] -=
            std::log (modes.dampingRatios[k] / prior.dampingRatios[k]) / (prior.dampingSpread * prior.dampingSpread);
    }
}

/** Products of the function velocity with itself and with what poles change: the same for all ceramics. */
struct VelocityProducts
{
    Eigen::MatrixXd own;                ///< N_m x N_m
    std::vector<Eigen::MatrixXd> poles; ///< Of each of polesAndDelay, N_m x N_m, in its unit.
};

VelocityProducts velocityProducts (const KnownModeState& state, const KnownModes& modes, double delayUnit)
{
    VelocityProducts result { productsOf (state, ModalFunction::velocity, ModalFunction::velocity) / state.variance,
                              {} };
    result.poles.reserve (polesAndDelay.size());

    for (const auto function : polesAndDelay)
        result.poles.emplace_back (productsOf (state, ModalFunction::velocity, function)
                                   * unitsOf (function, modes, delayUnit).asDiagonal() / state.variance);

    return result;
}

/** Eliminates the strengths of one ceramic. */
void eliminate (KnownModeEquations& equations, const KnownModeState& state, const VelocityProducts& products,
                const KnownModes& modes, const KnownModePrior& prior, const Eigen::MatrixXd& strengths,
                Eigen::Index ceramic)
{
    const auto count = modes.modes(), points = state.weightedShapes.cols() / strengths.cols();
    const auto& shapes = state.shapes[static_cast<std::size_t> (ceramic)];
    const Eigen::VectorXd precisions =
        (modes.angularFrequencies.array() / prior.participationSpreads.col (ceramic).array()).square().matrix();
    Eigen::MatrixXd matrix = products.own.cwiseProduct (shapes);
    matrix.diagonal() += precisions;
    Eigen::MatrixXd coupling = Eigen::MatrixXd::Zero (count, columnsOfPoles (count) + 1);

    for (std::size_t b = 0; b < polesAndDelay.size(); ++b)
        place (coupling, products.poles[b].cwiseProduct (shapes) * strengths.col (ceramic).asDiagonal(), b, count);

    const auto columns = Eigen::seqN (ceramic * points, points);
    coupling.rightCols (1) = state.errors (functionsOf (ModalFunction::velocity, count), columns)
                                     .cwiseProduct (state.weightedShapes (Eigen::all, columns))
                                     .rowwise()
                                     .sum()
                                 / state.variance
                             - precisions.cwiseProduct (modes.angularFrequencies.cwiseInverse().cwiseProduct (
                                 modes.participation.col (ceramic) - prior.participation.col (ceramic)));
    factorLower (matrix); // Positive definite by the prior.
    solveLower (matrix, coupling);
    const Eigen::MatrixXd transposed = coupling.transpose();
    Eigen::MatrixXd taken = Eigen::MatrixXd::Zero (transposed.rows(), transposed.rows());
    addGram (taken, -1, transposed);
    const auto poles = columnsOfPoles (count);
    equations.poles += taken.topLeftCorner (poles, poles);
    equations.gradient += taken.row (poles).head (poles).transpose();
    equations.factors.push_back (std::move (matrix));
    equations.couplings.push_back (std::move (coupling));
}
} // namespace

KnownModeEquations knownModeEquations (const KnownModeState& state, const KnownModes& modes,
                                       const KnownModePrior& prior)
{
    KnownModeEquations equations;
    equations.delayUnit = 1 / modes.angularFrequencies.maxCoeff();
    const auto strengths = strengthsOf (modes);
    equations.poles = poleMatrix (state, modes, strengths, equations.delayUnit) / state.variance;
    equations.gradient = poleGradient (state, modes, strengths, equations.delayUnit) / state.variance;
    addPolePrior (equations, modes, prior);
    const auto products = velocityProducts (state, modes, equations.delayUnit);

    for (Eigen::Index i = 0; i < strengths.cols(); ++i)
    {
        checkWatch();
        eliminate (equations, state, products, modes, prior, strengths, i);
    }

    return equations;
}

KnownModeStep solve (const KnownModeEquations& equations, double reach)
{
    const Eigen::VectorXd scale = equations.poles.diagonal().cwiseMax (1e-300).cwiseSqrt().cwiseInverse();
    Eigen::MatrixXd matrix = scale.asDiagonal() * equations.poles * scale.asDiagonal();
    matrix.diagonal().array() += ridge;
    const Eigen::VectorXd bounds = reach * scale.cwiseInverse(),
                          scaled =
                              boundedStep (matrix, scale.cwiseProduct (equations.gradient), -bounds, bounds).change,
                          poles = scale.cwiseProduct (scaled);
    const auto count = (poles.size() - 1) / 2;
    KnownModeStep step { poles.head (2 * count),
                         Eigen::MatrixXd (count, static_cast<Eigen::Index> (equations.factors.size())),
                         poles[2 * count] * equations.delayUnit,
                         equations.gradient.dot (poles)
                             - poles.dot (equations.poles.selfadjointView<Eigen::Lower>() * poles) / 2 };

    for (std::size_t i = 0; i < equations.factors.size(); ++i)
    {
        const auto& coupling = equations.couplings[i];
        Eigen::MatrixXd right = coupling.rightCols (1) - coupling.leftCols (poles.size()) * poles;
        step.gain += coupling.rightCols (1).squaredNorm() / 2;
        solveLowerTransposed (equations.factors[i], right);
        step.strengths.col (static_cast<Eigen::Index> (i)) = right;
    }

    return step;
}

KnownModeDeviations deviationsOf (const KnownModeEquations& equations)
{
    const auto count = (equations.gradient.size() - 1) / 2;
    const auto deviations = [] (const Eigen::MatrixXd& factor)
    {
        Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity (factor.rows(), factor.rows());
        solveLower (factor, inverse);
        return Eigen::VectorXd (inverse.colwise().norm().transpose());
    };
    KnownModeDeviations result { Eigen::VectorXd::Zero (2 * count),
                                 Eigen::MatrixXd (count, static_cast<Eigen::Index> (equations.factors.size())) };
    auto matrix = equations.poles;

    if (factorLower (matrix))
        result.poles = deviations (matrix).head (2 * count);

    for (std::size_t i = 0; i < equations.factors.size(); ++i)
        result.strengths.col (static_cast<Eigen::Index> (i)) = deviations (equations.factors[i]);

    return result;
}
} // namespace antinode
