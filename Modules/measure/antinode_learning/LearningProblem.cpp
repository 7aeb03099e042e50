#include "LearningProblem.h"

#include "LearningEquations.h"
#include "ParameterEffects.h"

#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/GaussNewton.h>
#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace antinode
{
namespace
{
constexpr int mostSteps = 12; // of each length of the records
constexpr int mostStepsOfResponses = 30;
constexpr double gainOfEach =
    0.05; // of the objective for each unknown, in squares of deviations: a step that gains less is the last
constexpr int stepsToJudge = 4;         // by then what comes close has left the worst behind
constexpr double clearlyTold = 10;      // of the prior's information
constexpr double farthestFrequency = 8; // deviations: a mode that runs away explains by chance and does not come back
constexpr double largestDistortion = 1.0 / 3; // at the largest voltage: beyond it a ceramic would move back
constexpr double farthestOfOthers = 1e3;      // the same of damping and participation, which take what no parameter has

/** Of each parameter, what responses let it move in a step of reach 1: a half width of a frequency, of the logarithm of
    a damping ratio, and for the delay a radian of the highest mode. */
Eigen::VectorXd stepLimitsOf (const LearningPrior& prior, const LearningParameters& parameters)
{
    Eigen::VectorXd limits = Eigen::VectorXd::Constant (parameters.size(), std::numeric_limits<double>::infinity());

    if (prior.responses == nullptr)
        return limits;

    for (Eigen::Index p = 0; p < parameters.ofModes(); ++p)
    {
        const auto& [kind, mode, sensor, ceramics, information] = parameters.modal[static_cast<std::size_t> (p)];

        if (kind == ParameterKind::frequency)
            limits[p] = prior.model.dampingRatios[mode] / prior.deviations.frequencies[mode];
        else if (kind == ParameterKind::damping)
            limits[p] = 1 / prior.deviations.dampings[mode];
    }

    limits[parameters.delay (parameters.delays - 1)] =
        1 / (prior.model.angularFrequencies.maxCoeff() * prior.deviations.delay);
    return limits;
}

/** Those of modes that recordings tell more of than a bound, the drift and the delays. Distortions are unknowns
    only where all parameters are. */
Unknowns unknownsAbove (double information, const LearningParameters& all)
{
    Unknowns unknowns { { {}, all.shared, all.delays }, {}, {} };

    for (Eigen::Index p = 0; p < all.ofModes(); ++p)
        if (const auto& parameter = all.modal[static_cast<std::size_t> (p)]; parameter.information > information)
        {
            unknowns.parameters.modal.push_back (parameter);
            unknowns.places.push_back (p);
        }

    for (auto p = all.ofModes(); p < all.distortion (0); ++p)
        unknowns.places.push_back (p);

    return unknowns;
}

Unknowns allOf (LearningParameters all)
{
    Unknowns unknowns { std::move (all), {}, {} };
    unknowns.places.resize (static_cast<std::size_t> (unknowns.parameters.size()));
    std::iota (unknowns.places.begin(), unknowns.places.end(), 0);
    return unknowns;
}

double distanceOf (double objective, double samples)
{
    return std::sqrt (objective / samples);
}

double distanceOf (const DataMisfit& misfit, const Eigen::VectorXd& values)
{
    return distanceOf (misfit.residual + values.squaredNorm(), misfit.samples);
}

/** Shared parameters change what those of modes do: their rows of the equations follow. A mixture is of few modes: most
    of its effects are 0. */
void addShared (DataEquations& equations, const Unknowns& unknowns)
{
    const auto& effects = unknowns.sharedEffects;
    const auto modal = effects.rows(), shared = effects.cols(), others = equations.matrix.rows() - modal - shared;

    if (shared == 0)
        return;

    auto& matrix = equations.matrix;
    auto ofModes = matrix.topLeftCorner (modal, modal);
    ofModes.triangularView<Eigen::StrictlyUpper>() = ofModes.transpose();
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero (modal, shared);
    parallelFor (static_cast<std::size_t> (shared),
                 [&] (std::size_t index)
                 {
                     const auto i = static_cast<Eigen::Index> (index);

                     for (Eigen::Index p = 0; p < modal; ++p)
                         if (effects (p, i) != 0)
                             products.col (i) += effects (p, i) * ofModes.col (p);
                 });
    matrix.block (modal, 0, shared, modal) = products.transpose();
    addTransposedLeft (matrix.block (modal, modal, shared, shared), 1, effects, products);
    addProduct (matrix.block (modal + shared, modal, others, shared), 1, matrix.bottomLeftCorner (others, modal),
                effects);
    equations.right.segment (modal, shared) = effects.transpose() * equations.right.head (modal);
}

/** What is left of a parameter's deviation, of all: the roots of the diagonal of the inverse of the matrix, of those of
    modes with what they share. The inverse of the factor is lower too, so that each block of columns begins at its own
    rows. */
Eigen::VectorXd deviationsLeft (const Eigen::MatrixXd& factored, const Eigen::MatrixXd& sharedEffects)
{
    const auto modal = sharedEffects.rows(), shared = sharedEffects.cols();
    constexpr Eigen::Index width = 256; // columns at a time
    Eigen::VectorXd left (factored.rows());

    for (Eigen::Index first = 0; first < factored.rows(); first += width)
    {
        const auto rows = factored.rows() - first, columns = std::min (width, rows);
        Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity (rows, columns);

        if (const auto some = std::min (columns, modal - first); some > 0)
            inverse.block (modal - first, 0, shared, some) = sharedEffects.middleRows (first, some).transpose();

        solveLower (factored.bottomRightCorner (rows, rows), inverse);
        left.segment (first, columns) = inverse.colwise().norm();
    }

    return left;
}

/** Shapes of modes, in columns, each with its share of the next one. */
Eigen::MatrixXd mixed (const Eigen::MatrixXd& shapes, const Eigen::VectorXd& mixtures)
{
    auto result = shapes;

    for (Eigen::Index k = 0; k + 1 < shapes.cols(); ++k)
    {
        result.col (k) += mixtures[k] * shapes.col (k + 1);
        result.col (k + 1) -= mixtures[k] * shapes.col (k);
    }

    return result;
}

/** Samples of a recording up to a time. */
Eigen::Index samplesOf (const PlayedRecording& recording, double time)
{
    const auto wanted = static_cast<Eigen::Index> (std::ceil (time * recording.sampleRate));
    return std::clamp<Eigen::Index> (wanted, 1, comparableSamples (recording));
}
} // namespace

LearningProblem::LearningProblem (const LearningPrior& given)
    : prior (given), every (allOf (heardParameters (given))), clear (unknownsAbove (clearlyTold, every.parameters)),
      farthest (Eigen::VectorXd::Constant (every.parameters.size(), farthestOfOthers)),
      stepLimits (stepLimitsOf (given, every.parameters))
{
    every.sharedEffects = effectsOfShared (given, every.parameters);
    clear.sharedEffects = effectsOfShared (given, clear.parameters);

    for (Eigen::Index p = 0; p < every.parameters.ofModes(); ++p)
        if (every.parameters.modal[static_cast<std::size_t> (p)].kind == ParameterKind::frequency)
            farthest[p] = farthestFrequency;

    farthest.tail (std::ssize (every.parameters.distorting))
        .setConstant (largestDistortion / given.deviations.distortion);
}

LearningState LearningProblem::state (const Eigen::VectorXd& values) const
{
    return stateAt (prior, every.parameters, values);
}

LearningSolution LearningProblem::solve (const Unknowns& unknowns, Eigen::VectorXd values, double time, double enough,
                                         double furthest, double hopeless) const
{
    const auto count = static_cast<double> (unknowns.parameters.size());
    const auto hasResponses = prior.responses != nullptr;
    const auto with = [&] (const Eigen::VectorXd& some)
    {
        auto all = values;
        all (unknowns.places) = some;
        return all;
    };
    auto samples = 0.0;
    SumOfSquares squares;
    squares.equations = [&] (const Eigen::VectorXd& some) -> SumOfSquares::Equations
    {
        const auto all = with (some);
        auto linear = equations (unknowns, all, time);
        samples = linear.misfit.samples;
        return { std::move (linear.matrix), std::move (linear.right), linear.misfit.residual + all.squaredNorm() };
    };
    squares.sum = [&] (const Eigen::VectorXd& some)
    {
        const auto all = with (some);
        return misfit (state (all), time).residual + all.squaredNorm();
    };
    GaussNewtonSettings settings { hasResponses ? mostStepsOfResponses : mostSteps,
                                   // Responses have no lengths to grow by: what their last step leaves stays.
                                   hasResponses ? gainOfEach : gainOfEach * count, enough,
                                   farthest (unknowns.places).cwiseMin (furthest), stepLimits (unknowns.places),
                                   [&] (int steps, double sum)
                                   { return steps == stepsToJudge && distanceOf (sum, samples) > hopeless; } };
    auto found = smallestSum (squares, values (unknowns.places), settings);
    return { with (found.values), std::move (found.factored), 0, 0, 0, 0 };
}

LearningSolution LearningProblem::finish (Eigen::VectorXd values, double time) const
{
    return judged (solve (every, std::move (values), time, finestGain, farthestOfOthers), time);
}

LearningSolution LearningProblem::judged (LearningSolution solution, double time) const
{
    const auto end = misfit (state (solution.values), time);
    solution.residual = std::sqrt (end.residual / end.samples);
    solution.unexplained = std::sqrt (end.residual / end.signal);
    solution.distance = distanceOf (end, solution.values);
    solution.largestMove = largestMoveHeardWell (solution.values);
    return solution;
}

LearntModes LearningProblem::learnt (const LearningSolution& solution) const
{
    const auto now = state (solution.values);
    const auto left = deviationsLeft (solution.factored, every.sharedEffects);
    const auto& deviations = prior.deviations;
    LearntModes learnt { prior.model,
                         prior.sensors,
                         now.delays,
                         now.distortions,
                         prior.distortionDeviations,
                         deviations.frequencies,
                         deviations.dampings,
                         prior.deviating.participation.rowwise().norm().cwiseQuotient (
                             prior.modes.participation.rowwise().norm().cwiseMax (1e-300)),
                         solution.residual,
                         solution.unexplained,
                         solution.distance,
                         solution.largestMove,
                         0,
                         0,
                         now.mixtures };
    learnt.model.angularFrequencies = now.model.angularFrequencies;
    learnt.model.dampingRatios = now.model.dampingRatios;
    learnt.model.participation = now.model.participation;
    learnt.model.shapes = mixed (prior.model.shapes, now.mixtures);
    learnt.model.slopes = mixed (prior.model.slopes, now.mixtures);

    for (std::size_t m = 0; m < learnt.sensors.size(); ++m)
        learnt.sensors[m].shapes = now.sensors.row (static_cast<Eigen::Index> (m));

    const auto& distorting = every.parameters.distorting;

    for (std::size_t i = 0; i < distorting.size(); ++i)
        learnt.distortionDeviations[distorting[i]] *= left[every.parameters.distortion (static_cast<Eigen::Index> (i))];

    for (std::size_t p = 0; p < every.parameters.modal.size(); ++p)
    {
        const auto& parameter = every.parameters.modal[p];
        const auto share = left[static_cast<Eigen::Index> (p)];
        const auto k = parameter.mode;

        if (parameter.kind == ParameterKind::frequency)
            learnt.frequencyDeviations[k] *= share;
        else if (parameter.kind == ParameterKind::damping)
            learnt.dampingDeviations[k] *= share;
        else if (parameter.kind == ParameterKind::participation)
            // Each heard combination takes its part of the mean square over all ceramics.
            learnt.participationDeviations[k] =
                std::sqrt (std::max (0.0, std::pow (learnt.participationDeviations[k], 2)
                                              - (1 - share * share)
                                                    * prior.deviating.participation.row (k)
                                                          .cwiseProduct (parameter.ceramics.transpose())
                                                          .squaredNorm()
                                                    / prior.modes.participation.row (k).squaredNorm()));
    }

    return learnt;
}

std::vector<Eigen::VectorXd> LearningProblem::noiseLeft (const Eigen::VectorXd& values, double time) const
{
    const auto now = state (values);
    std::vector<Eigen::VectorXd> left;

    for (Eigen::Index r = 0; r < std::ssize (prior.recordings); ++r)
    {
        const auto residual = recordingResidual (prior, now, r, samplesOf (recording (r), time));
        Eigen::VectorXd deviations (residual.cols());

        for (Eigen::Index m = 0; m < residual.cols(); ++m)
            deviations[m] = std::sqrt (powerAsWhiteNoise (residual.col (m)));

        left.push_back (std::move (deviations));
    }

    return left;
}

double LearningProblem::unexplainedShare (const Eigen::VectorXd& values, Eigen::Index sensor, double time) const
{
    const auto now = state (values);
    double residual = 0, signal = 0;

    for (Eigen::Index r = 0; r < std::ssize (prior.recordings); ++r)
    {
        const auto samples = samplesOf (recording (r), time);
        residual += recordingResidual (prior, now, r, samples).col (sensor).squaredNorm();
        signal +=
            prior.signals[static_cast<std::size_t> (r)]->earlier (now.delays[r], samples).col (sensor).squaredNorm();
    }

    return signal > 0 ? residual / signal : 0;
}

double LearningProblem::distance (const Eigen::VectorXd& values, double time) const
{
    return distanceOf (misfit (state (values), time), values);
}

/** Frequencies near half the rate, or beyond it, are told by what modes do as springs: they explain by chance. */
double LearningProblem::largestMoveHeardWell (const Eigen::VectorXd& values) const
{
    constexpr double heardWell = 0.4; // of the lowest sample rate
    auto rate = std::numeric_limits<double>::infinity();

    for (const auto& each : prior.recordings)
        rate = std::min (rate, each.sampleRate);

    auto most = 0.0;

    for (Eigen::Index p = 0; p < every.parameters.ofModes(); ++p)
        if (const auto& parameter = every.parameters.modal[static_cast<std::size_t> (p)];
            parameter.kind == ParameterKind::frequency && prior.model.frequencyHz (parameter.mode) < heardWell * rate)
            most = std::max (most, std::abs (values[p]));

    return most;
}

DataMisfit LearningProblem::misfit (const LearningState& now, double time) const
{
    DataMisfit sum;

    if (prior.responses != nullptr)
        sum = responseMisfit (prior, now);

    for (Eigen::Index r = 0; r < std::ssize (prior.recordings); ++r)
        sum += recordingMisfit (prior, now, r, samplesOf (recording (r), time));

    return sum;
}

/** Of some unknowns, with what is known of them before. */
DataEquations LearningProblem::equations (const Unknowns& unknowns, const Eigen::VectorXd& values, double time) const
{
    const auto now = state (values);
    DataEquations sum;

    if (prior.responses != nullptr)
        sum = responseEquations (prior, unknowns.parameters, now);

    for (Eigen::Index r = 0; r < std::ssize (prior.recordings); ++r)
    {
        auto one = recordingEquations (prior, unknowns.parameters, now, r, samplesOf (recording (r), time));

        if (sum.right.size() == 0)
        {
            sum = std::move (one);
            continue;
        }

        sum.matrix += one.matrix;
        sum.right += one.right;
        sum.misfit += one.misfit;
    }

    addShared (sum, unknowns);
    sum.matrix.diagonal().array() += 1;
    sum.right -= values (unknowns.places);
    return sum;
}

const PlayedRecording& LearningProblem::recording (Eigen::Index r) const
{
    return prior.recordings[static_cast<std::size_t> (r)];
}
} // namespace antinode
