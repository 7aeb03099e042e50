#include "KnownModeFit.h"

#include "FitErrors.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/GaussNewton.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double enough = 0.05;  ///< Of log posterior: a step that gains less is the last one.
constexpr double roughly = 1e-5; ///< Of the noise's variance: the same where weights and scales are found.
constexpr int maximumSteps = 30;
constexpr double firstReach = 1, farthest = 8, nearest = 1e-3; ///< Half widths that a pole may move in a step.
constexpr double littleGained = 0.25, mostGained = 0.75;       ///< Of what a step was to gain.

KnownModes afterStep (KnownModes modes, const KnownModeStep& step)
{
    for (Eigen::Index k = 0; k < modes.modes(); ++k)
    {
        const auto resonance = modes.angularFrequencies[k], before = modes.dampingRatios[k];
        modes.angularFrequencies[k] *= std::exp (before * step.poles[k]);
        modes.dampingRatios[k] = std::clamp (before * std::exp (step.poles[modes.modes() + k]), 1e-9, 0.9);
        modes.participation.row (k) += resonance * step.strengths.row (k);
    }

    return modes;
}

/** Half the squares of what differs from the prior, in standard deviations. */
double priorCost (const KnownModes& modes, const KnownModePrior& prior)
{
    const auto frequencies =
        (modes.angularFrequencies.array() / prior.angularFrequencies.array()).log() / prior.frequencySpreads.array();
    const auto dampings = (modes.dampingRatios.array() / prior.dampingRatios.array()).log() / prior.dampingSpread;
    const auto participation = (modes.participation - prior.participation).array() / prior.participationSpreads.array();
    return (frequencies.square().sum() + dampings.square().sum() + participation.square().sum()) / 2;
}

/** Where the search for the most probable modes is. */
struct Search
{
    KnownModes modes;
    double delay = 0;
    KnownModeState state;
    double cost = 0; ///< - log posterior.
};

class Searcher
{
public:
    Searcher (PreparedResponses& dataToUse, KnownModePrior priorToUse, double delay)
        : data (dataToUse), prior (std::move (priorToUse)), moments (lineMoments (data, delay))
    {
    }

    Search at (KnownModes modes, double delay)
    {
        checkWatch();

        if (! isNear (moments, delay))
            moments = lineMoments (data, delay);

        auto state = knownModeState (data, moments, modes, delay);
        const auto cost = state.values / 2 * std::log (state.variance) + priorCost (modes, prior);
        return { std::move (modes), delay, std::move (state), cost };
    }

    /** Goes on until a step gains less of log posterior. @return  the equations there */
    KnownModeEquations run (Search& best, double leastGain)
    {
        auto equations = knownModeEquations (best.state, best.modes, prior);
        auto reach = firstReach;

        for (int steps = 0; steps < maximumSteps && reach > nearest; ++steps)
        {
            const auto step = solve (equations, reach);

            if (! (step.gain >= leastGain))
                break;

            auto next = at (afterStep (best.modes, step), best.delay + step.delay);
            const auto share = (best.cost - next.cost) / step.gain;
            reach = share > mostGained ? std::min (2 * reach, farthest) : share > littleGained ? reach : reach / 4;

            if (! (next.cost <= best.cost))
                continue;

            best = std::move (next);
            equations = knownModeEquations (best.state, best.modes, prior);
        }

        return equations;
    }

    /** Weights from what is left; participations are as before, times a factor of each ceramic. @return  the factors */
    Eigen::VectorXd learnFromFirst (Search& best)
    {
        auto scales = scalesOf (best.modes.participation, prior.participation);
        prior.participation *= scales.asDiagonal();
        weighByErrors (data, fitErrors (data, best.state.basis, best.state.coefficients, best.delay));
        moments = lineMoments (data, best.delay);
        best = at (std::move (best.modes), best.delay);
        return scales;
    }

private:
    PreparedResponses& data;
    KnownModePrior prior;
    LineMoments moments;
};
} // namespace

Eigen::VectorXd scalesOf (const Eigen::MatrixXd& found, const Eigen::MatrixXd& known)
{
    const auto weights = known.rowwise().squaredNorm().cwiseMax (1e-300).cwiseInverse().eval();
    const Eigen::VectorXd between = known.cwiseProduct (found).transpose() * weights,
                          squares = known.cwiseAbs2().transpose() * weights;
    return (squares.array() > 1e-12).select (between.cwiseQuotient (squares.cwiseMax (1e-300)), 1);
}

KnownModeFit fitKnownModes (PreparedResponses& data, const KnownModes& start, const KnownModePrior& prior, double delay)
{
    Searcher searcher (data, prior, delay);
    auto best = searcher.at (start, delay);
    KnownModeFit result;
    searcher.run (best, roughly * best.state.values / 2);
    result.participationScales = searcher.learnFromFirst (best);
    const auto deviations = deviationsOf (searcher.run (best, enough));
    const auto modes = best.modes.modes();
    result.frequencyDeviations = deviations.poles.head (modes).cwiseProduct (best.modes.dampingRatios);
    result.dampingDeviations = deviations.poles.segment (modes, modes);
    result.participationDeviations =
        (deviations.strengths.rowwise().norm().array() * best.modes.angularFrequencies.array()
         / best.modes.participation.rowwise().norm().array().max (1e-300))
            .matrix();
    result.pointErrors = best.state.pointErrors;
    result.reconstructionError = best.state.reconstructionError;
    result.delay = best.delay;
    result.modes = std::move (best.modes);
    return result;
}

Eigen::MatrixXd strengthsOf (const KnownModes& modes)
{
    return modes.angularFrequencies.cwiseInverse().asDiagonal() * modes.participation;
}

KnownModeState knownModeState (const PreparedResponses& data, const LineMoments& moments, const KnownModes& modes,
                               double delay)
{
    const auto count = modes.modes(), points = data.points(), references = data.references();
    KnownModeState state;
    state.basis = makeBasis (modes.angularFrequencies, modes.dampingRatios, data);
    const auto products = modalProducts (state.basis, data, moments, delay);
    state.reduced = withoutPowers (state.basis, products);
    const auto strengths = strengthsOf (modes);
    Eigen::MatrixXd amplitudes (count, data.columns());
    state.weightedShapes.resize (count, data.columns());

    for (Eigen::Index i = 0; i < references; ++i)
    {
        const auto columns = Eigen::seqN (i * points, points);
        amplitudes (Eigen::all, columns) = strengths.col (i).asDiagonal() * modes.shapes.transpose();
        state.weightedShapes (Eigen::all, columns) =
            modes.shapes.transpose() * data.columnWeights.segment (i * points, points).asDiagonal();
        state.shapes.emplace_back (state.weightedShapes (Eigen::all, columns) * modes.shapes);
    }

    state.errors = state.reduced.data;
    const Eigen::MatrixXd toVelocity = state.reduced.gram (Eigen::all, functionsOf (ModalFunction::velocity, count));
    addProduct (state.errors, -1, toVelocity, amplitudes);
    const auto velocity = functionsOf (ModalFunction::velocity, count);
    const Eigen::VectorXd costs =
        state.reduced.energies
        - amplitudes.cwiseProduct (state.reduced.data (velocity, Eigen::all) + state.errors (velocity, Eigen::all))
              .colwise()
              .sum()
              .transpose();
    const auto energy = products.energies.dot (data.columnWeights),
               left = std::max (costs.dot (data.columnWeights), 1e-20 * energy);
    state.values = 2 * static_cast<double> (data.lines() * (data.columnWeights.array() > 0).count());
    state.variance = left / state.values;
    state.reconstructionError = 10 * std::log10 (left / energy);
    const auto ofPoints = [&] (const Eigen::VectorXd& columns) -> Eigen::VectorXd
    { return columns.cwiseProduct (data.columnWeights).reshaped (points, references).rowwise().sum(); };
    state.pointErrors =
        (ofPoints (costs).cwiseMax (0).array() / ofPoints (products.energies).array().max (1e-300)).sqrt().matrix();
    state.coefficients = Eigen::MatrixXd::Zero (state.basis.size(), data.columns());
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero (state.basis.modalColumns(), data.columns());
    all (velocity, Eigen::all) = amplitudes;
    state.coefficients << all, powerCoefficients (state.basis, products, all);
    return state;
}

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
