#include "LearningProblem.h"

#include "HeardParameters.h"

#include <antinode_numerics/BoundedStep.h>
#include <antinode_numerics/DenseKernels.h>
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
constexpr double gainOfEach =
    0.05; // of the objective for each unknown, in squares of deviations: a step that gains less is the last
constexpr int stepsToJudge = 4;         // by then what comes close has left the worst behind
constexpr double smallestShare = 0.125; // of a step
constexpr double clearlyTold = 10;      // of the prior's information
constexpr double farthestFrequency = 8; // deviations: a mode that runs away explains by chance and does not come back
constexpr double largestDistortion = 1.0 / 3; // at the largest voltage: beyond it a ceramic would move back
constexpr double farthestOfOthers = 1e3;      // the same of damping and participation, which take what no parameter has

/** Those of modes that recordings tell more of than a bound, the drift and the delays. Distortions are unknowns
    only where all parameters are. */
Unknowns unknownsAbove (double information, const LearningParameters& all)
{
    Unknowns unknowns { { {}, all.shared, all.recordings }, {}, {} };

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

double distanceOf (const RecordingMisfit& misfit, const Eigen::VectorXd& values)
{
    return distanceOf (misfit.residual + values.squaredNorm(), misfit.samples);
}

/** Shared parameters change what those of modes do: their rows of the equations follow. A mixture is of few modes: most
    of its effects are 0. */
void addShared (RecordingEquations& equations, const Unknowns& unknowns)
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

/** Samples of a recording up to a time. */
Eigen::Index samplesOf (const PlayedRecording& recording, double time)
{
    const auto wanted = static_cast<Eigen::Index> (std::ceil (time * recording.sampleRate));
    return std::clamp<Eigen::Index> (wanted, 1, comparableSamples (recording));
}
} // namespace

LearningProblem::LearningProblem (const LearningPrior& given)
    : prior (given), every (allOf (heardParameters (given))), clear (unknownsAbove (clearlyTold, every.parameters)),
      farthest (Eigen::VectorXd::Constant (every.parameters.size(), farthestOfOthers))
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
    const Eigen::VectorXd bounds = farthest (unknowns.places).cwiseMin (furthest);
    const auto least = gainOfEach * static_cast<double> (unknowns.parameters.size());
    LearningSolution solution { std::move (values), {}, 0, 0, 0, 0 };
    auto gain = std::numeric_limits<double>::infinity(), objective = 0.0;
    BoundedStep step;
    Eigen::MatrixXd matrix; // the step's

    for (int i = 0; i < mostSteps && gain >= least + enough * objective; ++i)
    {
        step.factored.resize (0, 0); // before others of its size are made
        matrix.resize (0, 0);
        auto linear = equations (unknowns, solution.values, time);
        const auto before = linear.misfit.residual + solution.values.squaredNorm();
        objective = before;
        const Eigen::VectorXd from = solution.values (unknowns.places);
        step = boundedStep (linear.matrix, linear.right, from, bounds);
        matrix = std::move (linear.matrix);

        for (auto share = 1.0; share >= smallestShare && ! (objective < before); share /= 2)
        {
            auto next = solution.values;
            next (unknowns.places) = (from + share * step.change).cwiseMax (-bounds).cwiseMin (bounds);
            const auto reached = misfit (state (next), time).residual + next.squaredNorm();

            if (reached < before)
            {
                objective = reached;
                solution.values = next;
            }
        }

        gain = before - objective;

        if (i + 1 == stepsToJudge && distanceOf (objective, linear.misfit.samples) > hopeless)
            break;
    }

    solution.factored = factorOfFree (std::move (step), std::move (matrix));
    return solution;
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

std::vector<Eigen::VectorXd> LearningProblem::noiseLeft (const Eigen::VectorXd& values, double time) const
{
    const auto now = state (values);
    std::vector<Eigen::VectorXd> left;

    for (Eigen::Index r = 0; r < every.parameters.recordings; ++r)
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

    for (Eigen::Index r = 0; r < every.parameters.recordings; ++r)
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

RecordingMisfit LearningProblem::misfit (const LearningState& now, double time) const
{
    RecordingMisfit sum;

    for (Eigen::Index r = 0; r < every.parameters.recordings; ++r)
        sum += recordingMisfit (prior, now, r, samplesOf (recording (r), time));

    return sum;
}

/** Of some unknowns, with what is known of them before. */
RecordingEquations LearningProblem::equations (const Unknowns& unknowns, const Eigen::VectorXd& values,
                                               double time) const
{
    const auto now = state (values);
    RecordingEquations sum;

    for (Eigen::Index r = 0; r < every.parameters.recordings; ++r)
    {
        auto one = recordingEquations (prior, unknowns.parameters, now, r, samplesOf (recording (r), time));

        if (r == 0)
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
