#include "LearnModes.h"

#include "HeardParameters.h"
#include "RecordingEquations.h"

#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr int mostSteps = 12;       // of each length of the records
constexpr double roughGain = 1e-2;  // of the objective, relative: less ends a length that is not the last
constexpr double finestGain = 1e-5; // the same of the last one, where something stays unexplained
constexpr double leastGain = 0.5;   // of the objective, in squares of deviations: less ends the last length
constexpr double firstPhase = 0.5;  // rad: by how much the highest mode may be off at the end of the first length
constexpr double lengthening = 2;
constexpr double farthestValue = 8;    // deviations: a mode that runs away explains by chance and does not come back
constexpr double farthestAtLast = 1e3; // the same of damping and participation, which take what ceramics distort
constexpr double missed = 1.2;         // of the noise is not explained: another minimum may do better

/** Where an iteration ended. */
struct Solution
{
    Eigen::VectorXd values;
    Eigen::MatrixXd factored;             ///< P x P: the matrix of a step close to the end, as factorLower leaves it.
    double residual = 0, unexplained = 0; ///< As in LearntModes, of records of the last length.
};

/** The problem with records of one length. */
class LearningProblem
{
public:
    explicit LearningProblem (const LearningPrior& given)
        : prior (given), parameters (heardParameters (given)),
          farthest (Eigen::VectorXd::Constant (parameters.size(), farthestAtLast))
    {
        for (std::size_t p = 0; p < parameters.modal.size(); ++p)
            if (parameters.modal[p].kind == ParameterKind::frequency)
                farthest[static_cast<Eigen::Index> (p)] = farthestValue;
    }

    Eigen::Index unknowns() const { return parameters.size(); }
    LearningState state (const Eigen::VectorXd& values) const { return stateAt (prior, parameters, values); }

    /** Samples of a recording up to a time. */
    static Eigen::Index samplesOf (const PlayedRecording& recording, double time)
    {
        const auto wanted = static_cast<Eigen::Index> (std::ceil (time * recording.sampleRate));
        return std::clamp<Eigen::Index> (wanted, 1, comparableSamples (recording));
    }

    double objective (const Eigen::VectorXd& values, double time) const
    {
        const auto now = state (values);
        auto sum = values.squaredNorm();

        for (Eigen::Index r = 0; r < parameters.recordings; ++r)
            sum += recordingMisfit (prior, now, r, samplesOf (recording (r), time));

        return sum;
    }

    /** @param withMatrix  without it there is none of the recordings', nor of the prior's */
    RecordingEquations equations (const Eigen::VectorXd& values, double time, bool withMatrix) const
    {
        const auto now = state (values);
        RecordingEquations sum { Eigen::MatrixXd (0, 0), -values };

        if (withMatrix)
            sum.matrix = Eigen::MatrixXd::Identity (unknowns(), unknowns());

        for (Eigen::Index r = 0; r < parameters.recordings; ++r)
        {
            const auto one =
                recordingEquations (prior, parameters, now, r, samplesOf (recording (r), time), withMatrix);

            if (withMatrix)
                sum.matrix += one.matrix;

            sum.right += one.right;
            sum.misfit += one.misfit;
            sum.signal += one.signal;
            sum.samples += one.samples;
        }

        return sum;
    }

    /** The most probable values with records up to a time, from values nearby. The matrix of a step serves those after
        it until one gains much, or too little: the minimum does not depend on it.
        @param furthest  deviations that no value leaves */
    Solution solve (Eigen::VectorXd values, double time, bool isLast, double furthest) const
    {
        const Eigen::VectorXd bounds = farthest.cwiseMin (furthest);
        constexpr double largeGain = 0.1; // of the objective
        Solution solution { std::move (values), {}, 0, 0 };
        auto linear = equations (solution.values, time, true);
        auto best = linear.misfit + solution.values.squaredNorm();
        auto isFresh = true;

        for (int i = 0; i < mostSteps; ++i)
        {
            if (isFresh)
            {
                solution.factored = std::move (linear.matrix);
                factorLower (solution.factored);
            }

            const Eigen::VectorXd change = solveFactored (solution.factored, linear.right);
            const auto before = best;
            auto share = 1.0;

            for (int halvings = 0; halvings < 4; ++halvings, share /= 2)
            {
                const Eigen::VectorXd next = (solution.values + share * change).cwiseMax (-bounds).cwiseMin (bounds);

                if (const auto reached = objective (next, time); reached < best)
                {
                    best = reached;
                    solution.values = next;
                    break;
                }
            }

            const auto gain = before - best;
            const auto isDone = gain < (isLast ? leastGain + finestGain * best : roughGain * best);

            // A matrix of elsewhere may be why.
            if (isDone && (isFresh || gain > 0))
                break;

            isFresh = gain > largeGain * before || share < 1 || isDone;
            linear = equations (solution.values, time, isFresh);
        }

        if (isLast)
        {
            const auto end = equations (solution.values, time, false);
            solution.residual = std::sqrt (end.misfit / end.samples);
            solution.unexplained = std::sqrt (end.misfit / end.signal);
        }

        return solution;
    }

    const LearningParameters& all() const { return parameters; }

private:
    const PlayedRecording& recording (Eigen::Index r) const { return prior.recordings[static_cast<std::size_t> (r)]; }

    const LearningPrior& prior;
    LearningParameters parameters;
    Eigen::VectorXd farthest; ///< P, deviations, of records of the last length.
};

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

/** What is left of a parameter's deviation, of all: the diagonal of the inverse of the matrix. */
Eigen::VectorXd deviationsLeft (const Eigen::MatrixXd& factored)
{
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity (factored.rows(), factored.cols());
    solveLower (factored, inverse);
    return inverse.colwise().norm().transpose();
}

LearntModes learntFrom (const LearningPrior& prior, const LearningProblem& problem, const Solution& solution)
{
    const auto state = problem.state (solution.values);
    const auto left = deviationsLeft (solution.factored);
    const auto ceramics = static_cast<double> (prior.model.actuators());
    const auto& deviations = prior.deviations;
    LearntModes learnt { prior.model,         prior.sensors,
                         state.delays,        deviations.frequencies,
                         deviations.dampings, deviations.participation,
                         solution.residual,   solution.unexplained };
    learnt.model.angularFrequencies = state.model.angularFrequencies;
    learnt.model.dampingRatios = state.model.dampingRatios;
    learnt.model.participation = state.model.participation;

    for (std::size_t m = 0; m < learnt.sensors.size(); ++m)
        learnt.sensors[m].shapes = state.sensors.row (static_cast<Eigen::Index> (m));

    for (std::size_t p = 0; p < problem.all().modal.size(); ++p)
    {
        const auto& parameter = problem.all().modal[p];
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
} // namespace

LearntModes learnModes (const ModalModel& model, const std::vector<Sensor>& sensors, const ModeSpread& deviations,
                        const std::vector<PlayedRecording>& recordings, const LearntModes* before)
{
    const auto prior = makePrior (model, sensors, deviations, recordings);
    const LearningProblem problem (prior);
    const auto longest = longestTime (recordings);

    if (before != nullptr)
        return learntFrom (prior, problem,
                           problem.solve (valuesOf (prior, problem.all(), *before), longest, true, farthestAtLast));

    // Which bounds lead to the right minimum differs from device to device: the next ones are tried where one is
    // missed.
    Solution best;

    for (const auto furthest : { farthestValue, farthestAtLast, farthestValue / 2 })
    {
        Eigen::VectorXd values = Eigen::VectorXd::Zero (problem.unknowns());
        auto time = firstTime (prior, problem.all());

        while (time < longest)
        {
            values = problem.solve (std::move (values), time, false, furthest).values;
            time *= lengthening;
        }

        auto solution = problem.solve (std::move (values), longest, true, farthestAtLast);

        if (best.values.size() == 0 || solution.residual < best.residual)
            best = std::move (solution);

        if (best.residual < missed)
            break;
    }

    return learntFrom (prior, problem, best);
}
} // namespace antinode
