#include "LearningProblem.h"

#include "HeardParameters.h"

#include <antinode_numerics/DenseKernels.h>

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
constexpr double smallestShare = 0.125;  // of a step
constexpr double clearlyTold = 10;       // of the prior's information
constexpr double farthestFrequency = 8;  // deviations: a mode that runs away explains by chance and does not come back
constexpr double farthestOfOthers = 1e3; // the same of damping and participation, which take what ceramics distort

/** Those of modes that recordings tell more of than a bound, the drift and the delays. What ceramics distort is looked
    for with all. */
Unknowns unknownsAbove (double information, const LearningParameters& all)
{
    Unknowns unknowns { { {}, all.recordings }, {} };

    for (Eigen::Index p = 0; p < all.drift(); ++p)
        if (const auto& parameter = all.modal[static_cast<std::size_t> (p)]; parameter.information > information)
        {
            unknowns.parameters.modal.push_back (parameter);
            unknowns.places.push_back (p);
        }

    for (auto p = all.drift(); p < all.distortion (0); ++p)
        unknowns.places.push_back (p);

    return unknowns;
}

Unknowns allOf (LearningParameters all)
{
    Unknowns unknowns { std::move (all), {} };
    unknowns.places.resize (static_cast<std::size_t> (unknowns.parameters.size()));
    std::iota (unknowns.places.begin(), unknowns.places.end(), 0);
    return unknowns;
}

/** Takes an unknown with a known change out of normal equations, of which the lower triangle is given. */
void takeOut (RecordingEquations& equations, Eigen::Index p, double change)
{
    auto& matrix = equations.matrix;
    const auto after = matrix.rows() - p - 1;
    equations.right.head (p) -= change * matrix.row (p).head (p).transpose();
    equations.right.tail (after) -= change * matrix.col (p).tail (after);
    matrix.row (p).setZero();
    matrix.col (p).setZero();
    matrix (p, p) = 1;
    equations.right[p] = change;
}

/** Which unknowns a step takes to their bounds: 1 to the upper, -1 to the lower one, 0 to neither. */
Eigen::VectorXi boundsReached (const Eigen::VectorXi& before, const Eigen::VectorXd& slope, const Eigen::VectorXd& next,
                               const Eigen::VectorXd& bounds)
{
    constexpr double rounding = 1e-9;
    Eigen::VectorXi reached (before.size());

    for (Eigen::Index p = 0; p < reached.size(); ++p)
    {
        const auto isPushedOn = before[p] != 0 && before[p] * slope[p] > 0;
        const auto isBeyond = before[p] == 0 && std::abs (next[p]) > bounds[p] + rounding;
        reached[p] = isPushedOn ? before[p] : isBeyond ? (next[p] > 0 ? 1 : -1) : 0;
    }

    return reached;
}

/** The step to the minimum within bounds, by a quadratic form of which the lower triangle is given. Cut off afterwards,
   a step may lead up. By sets of unknowns at their bounds, Hintermueller, Ito and Kunisch, SIAM Journal on Optimization
    13, 2003.
    @return  of each unknown; the matrix is then factored, as factorLower leaves it, those at bounds taken out */
Eigen::VectorXd stepWithin (RecordingEquations& equations, const Eigen::VectorXd& values, const Eigen::VectorXd& bounds)
{
    constexpr int mostRounds = 8;
    Eigen::VectorXi atBound = Eigen::VectorXi::Zero (values.size());

    for (int round = 1;; ++round)
    {
        auto free = equations;

        for (Eigen::Index p = 0; p < values.size(); ++p)
            if (atBound[p] != 0)
                takeOut (free, p, atBound[p] * bounds[p] - values[p]);

        factorLower (free.matrix);
        const Eigen::VectorXd change = solveFactored (free.matrix, free.right);
        const Eigen::VectorXd slope = equations.right - equations.matrix.selfadjointView<Eigen::Lower>() * change;
        const auto reached = boundsReached (atBound, slope, values + change, bounds);

        if (reached == atBound || round == mostRounds)
        {
            equations.matrix = std::move (free.matrix);
            return (values + change).cwiseMax (-bounds).cwiseMin (bounds) - values;
        }

        atBound = reached;
    }
}

double distanceOf (const RecordingMisfit& misfit, const Eigen::VectorXd& values)
{
    return std::sqrt ((misfit.residual + values.squaredNorm()) / misfit.samples);
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
    for (Eigen::Index p = 0; p < every.parameters.drift(); ++p)
        if (every.parameters.modal[static_cast<std::size_t> (p)].kind == ParameterKind::frequency)
            farthest[p] = farthestFrequency;
}

LearningState LearningProblem::state (const Eigen::VectorXd& values) const
{
    return stateAt (prior, every.parameters, values);
}

LearningSolution LearningProblem::solve (const Unknowns& unknowns, Eigen::VectorXd values, double time, double enough,
                                         double furthest) const
{
    const Eigen::VectorXd bounds = farthest (unknowns.places).cwiseMin (furthest);
    const auto least = gainOfEach * static_cast<double> (unknowns.parameters.size());
    LearningSolution solution { std::move (values), {}, 0, 0, 0, 0 };
    auto gain = std::numeric_limits<double>::infinity(), objective = 0.0;

    for (int i = 0; i < mostSteps && gain >= least + enough * objective; ++i)
    {
        solution.factored.resize (0, 0); // before another one of its size is made
        auto linear = equations (unknowns, solution.values, time);
        const auto before = linear.misfit.residual + solution.values.squaredNorm();
        objective = before;
        const Eigen::VectorXd from = solution.values (unknowns.places);
        const Eigen::VectorXd change = stepWithin (linear, from, bounds);
        solution.factored = std::move (linear.matrix);

        for (auto share = 1.0; share >= smallestShare && ! (objective < before); share /= 2)
        {
            auto next = solution.values;
            next (unknowns.places) = (from + share * change).cwiseMax (-bounds).cwiseMin (bounds);
            const auto reached = misfit (state (next), time).residual + next.squaredNorm();

            if (reached < before)
            {
                objective = reached;
                solution.values = next;
            }
        }

        gain = before - objective;
    }

    return solution;
}

LearningSolution LearningProblem::finish (Eigen::VectorXd values, double time) const
{
    auto solution = solve (every, std::move (values), time, finestGain, farthestOfOthers);
    const auto end = misfit (state (solution.values), time);
    solution.residual = std::sqrt (end.residual / end.samples);
    solution.unexplained = std::sqrt (end.residual / end.signal);
    solution.distance = distanceOf (end, solution.values);
    solution.largestMove = largestMoveHeardWell (solution.values);
    return solution;
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

    for (Eigen::Index p = 0; p < every.parameters.drift(); ++p)
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

    sum.matrix.diagonal().array() += 1;
    sum.right -= values (unknowns.places);
    return sum;
}

const PlayedRecording& LearningProblem::recording (Eigen::Index r) const
{
    return prior.recordings[static_cast<std::size_t> (r)];
}
} // namespace antinode
