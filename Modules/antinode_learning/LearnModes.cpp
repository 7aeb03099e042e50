#include "LearnModes.h"

#include "LearningProblem.h"

#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace antinode
{
namespace
{
constexpr double roughGain = 1e-2; // of the objective, relative: less ends a length that is not the last
constexpr double firstPhase = 0.5; // rad: by how much the highest mode may be off at the end of the first length
constexpr double lengthening = 2;
constexpr double missed = 1.2; // of the noise is not explained: another minimum may do better
constexpr double unlikely = 6; // deviations: two of 1e9 normal numbers are farther off
constexpr double unbounded = std::numeric_limits<double>::infinity(); // no bound but the problem's own
constexpr double notTried = unbounded;                                // a misfit

constexpr std::array boundsToTry { 8.0, unbounded, 4.0 }; // deviations that no value leaves while the record grows

/** s: until when no mode can be off by more than firstPhase after the voltages have ended or, where they do not end
    before, from the loudest moment on. */
double firstTime (const LearningPrior& prior, const LearningParameters& parameters)
{
    const auto& recording = prior.recordings.front();
    Eigen::Index loudest = 0;
    recording.signals.colwise().squaredNorm().maxCoeff (&loudest);
    double fastest = 0; // rad/s that a mode can be off

    for (const auto& parameter : parameters.modal)
        if (parameter.kind == ParameterKind::frequency)
            fastest = std::max (fastest, (prior.deviations.frequencies[parameter.mode] + prior.deviations.drift)
                                             * prior.model.angularFrequencies[parameter.mode]);

    const auto wait = fastest > 0 ? firstPhase / fastest : 1.0;
    return std::max (0.0, static_cast<double> (loudest) / recording.sampleRate - recording.delay) + wait;
}

double longestTime (const std::vector<PlayedRecording>& recordings)
{
    double longest = 0;

    for (const auto& recording : recordings)
        longest = std::max (longest, static_cast<double> (recording.voltages.cols()) / recording.sampleRate);

    return longest;
}

/** What is left of a parameter's deviation, of all: the roots of the diagonal of the inverse of the matrix. The inverse
    of the factor is lower too, so that each block of columns begins at its own rows. */
Eigen::VectorXd deviationsLeft (const Eigen::MatrixXd& factored)
{
    constexpr Eigen::Index width = 256; // columns at a time
    Eigen::VectorXd left (factored.rows());

    for (Eigen::Index first = 0; first < factored.rows(); first += width)
    {
        const auto rows = factored.rows() - first, columns = std::min (width, rows);
        Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity (rows, columns);
        solveLower (factored.bottomRightCorner (rows, rows), inverse);
        left.segment (first, columns) = inverse.colwise().norm();
    }

    return left;
}

LearntModes learntFrom (const LearningPrior& prior, const LearningProblem& problem, const LearningSolution& solution)
{
    const auto state = problem.state (solution.values);
    const auto left = deviationsLeft (solution.factored);
    const auto ceramics = static_cast<double> (prior.model.actuators());
    const auto& deviations = prior.deviations;
    LearntModes learnt { prior.model,
                         prior.sensors,
                         state.delays,
                         state.distortions,
                         prior.distortionDeviations,
                         deviations.frequencies,
                         deviations.dampings,
                         deviations.participation,
                         solution.residual,
                         solution.unexplained,
                         solution.distance,
                         solution.largestMove };
    learnt.model.angularFrequencies = state.model.angularFrequencies;
    learnt.model.dampingRatios = state.model.dampingRatios;
    learnt.model.participation = state.model.participation;

    for (std::size_t m = 0; m < learnt.sensors.size(); ++m)
        learnt.sensors[m].shapes = state.sensors.row (static_cast<Eigen::Index> (m));

    const auto& distorting = problem.all().parameters.distorting;

    for (std::size_t i = 0; i < distorting.size(); ++i)
        learnt.distortionDeviations[distorting[i]] *=
            left[problem.all().parameters.distortion (static_cast<Eigen::Index> (i))];

    for (std::size_t p = 0; p < problem.all().parameters.modal.size(); ++p)
    {
        const auto& parameter = problem.all().parameters.modal[p];
        const auto share = left[static_cast<Eigen::Index> (p)];
        const auto k = parameter.mode;

        if (parameter.kind == ParameterKind::frequency)
            learnt.frequencyDeviations[k] *= share;
        else if (parameter.kind == ParameterKind::damping)
            learnt.dampingDeviations[k] *= share;
        else if (parameter.kind == ParameterKind::participation)
            // Each heard combination takes its part of the mean square over all ceramics.
            learnt.participationDeviations[k] = std::sqrt (
                std::max (0.0, std::pow (learnt.participationDeviations[k], 2)
                                   - std::pow (deviations.participation[k], 2) * (1 - share * share) / ceramics));
    }

    return learnt;
}

bool isMissed (double residual, double largestMove)
{
    return ! (residual < missed) || isUnlikelyMove (largestMove);
}

/** Values of all parameters after the record has grown to the last length before its whole one, from the known device.
    @param furthest  deviations that no value leaves meanwhile */
Eigen::VectorXd grownWithin (double furthest, const LearningPrior& prior, const LearningProblem& problem,
                             double longest)
{
    Eigen::VectorXd values = Eigen::VectorXd::Zero (problem.all().parameters.size());
    auto time = firstTime (prior, problem.all().parameters);

    while (time < longest)
    {
        values = problem.solve (problem.clearlyHeard(), std::move (values), time, roughGain, furthest).values;
        time *= lengthening;
    }

    return values;
}

/** Which bounds lead to the right minimum differs from device to device: the next ones are tried where it is missed.
    Where all miss it, the one of least distance counts; of those that show it before the last steps, which take most of
    the time, the nearest alone goes on to the end. */
LearningSolution fromTheBeginning (const LearningPrior& prior, const LearningProblem& problem, double longest)
{
    std::optional<LearningSolution> best;
    std::optional<Eigen::VectorXd> leftOut;
    auto nearest = unbounded;

    for (const auto furthest : boundsToTry)
    {
        auto values = grownWithin (furthest, prior, problem, longest);

        if (isUnlikelyMove (problem.largestMoveHeardWell (values)))
        {
            if (const auto distance = problem.distance (values, longest); ! leftOut || distance < nearest)
            {
                nearest = distance;
                leftOut = std::move (values);
            }

            continue;
        }

        auto solution = problem.finish (std::move (values), longest);

        if (! isMissed (solution.residual, solution.largestMove))
            return solution;

        if (! best || solution.distance < best->distance)
            best = std::move (solution);
    }

    if (leftOut && (! best || nearest < best->distance))
        if (auto solution = problem.finish (std::move (*leftOut), longest);
            ! best || solution.distance < best->distance)
            best = std::move (solution);

    return std::move (*best);
}
} // namespace

bool isUnlikelyMove (double deviations)
{
    return deviations > unlikely;
}

bool isMissed (const LearntModes& learnt)
{
    return isMissed (learnt.residual, learnt.largestMove);
}

LearntModes learnModes (const ModalModel& model, const std::vector<Sensor>& sensors, const ModeSpread& deviations,
                        const std::vector<PlayedRecording>& recordings, const LearntModes* before)
{
    const auto prior = makePrior (model, sensors, deviations, recordings);
    const LearningProblem problem (prior);
    const auto longest = longestTime (recordings);

    if (before != nullptr)
    {
        auto values = valuesOf (prior, problem.all().parameters, *before);
        values =
            problem.solve (problem.clearlyHeard(), std::move (values), longest, LearningProblem::finestGain, unbounded)
                .values;
        return learntFrom (prior, problem, problem.finish (std::move (values), longest));
    }

    return learntFrom (prior, problem, fromTheBeginning (prior, problem, longest));
}

std::array<double, 2> misfitsOfBeginning (const ModalModel& model, const std::vector<Sensor>& sensors,
                                          const ModeSpread& deviations, PlayedRecording recording, double enough,
                                          const std::array<double, 2>& hopeless)
{
    const std::vector<PlayedRecording> one { std::move (recording) };
    const auto prior = makePrior (model, sensors, deviations, one);
    const LearningProblem problem (prior);
    const auto time = firstTime (prior, problem.all().parameters);
    const Eigen::VectorXd nominal = Eigen::VectorXd::Zero (problem.all().parameters.size());
    const auto misfit = [&] (std::size_t bound)
    {
        const auto values =
            problem.solve (problem.clearlyHeard(), nominal, time, roughGain, boundsToTry[bound], hopeless[bound])
                .values;
        return problem.distance (values, time);
    };
    const auto first = misfit (0);
    return { first, first < enough || first > hopeless[0] ? notTried : misfit (1) };
}
} // namespace antinode
