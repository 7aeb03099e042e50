#include "LearnModes.h"

#include "HeardParameters.h"
#include "RecordingEquations.h"
#include "ShiftedSignals.h"

#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>

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

/** The problem with records of one length. */
class LearningProblem
{
public:
    explicit LearningProblem (const LearningPrior& given) : prior (given), parameters (heardParameters (given)) {}

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

    RecordingEquations equations (const Eigen::VectorXd& values, double time) const
    {
        const auto now = state (values);
        RecordingEquations sum { Eigen::MatrixXd::Identity (unknowns(), unknowns()), -values };

        for (Eigen::Index r = 0; r < parameters.recordings; ++r)
        {
            const auto one = recordingEquations (prior, parameters, now, r, samplesOf (recording (r), time));
            sum.matrix += one.matrix;
            sum.right += one.right;
            sum.misfit += one.misfit;
            sum.signal += one.signal;
            sum.samples += one.samples;
        }

        return sum;
    }

    /** The most probable values with records up to a time, from values nearby. */
    Eigen::VectorXd solve (Eigen::VectorXd values, double time, bool isLast) const
    {
        auto best = objective (values, time);

        for (int i = 0; i < mostSteps; ++i)
        {
            auto linear = equations (values, time);
            factorLower (linear.matrix);
            const Eigen::VectorXd change = solveFactored (linear.matrix, linear.right);
            const auto before = best;

            auto share = 1.0;

            for (int halvings = 0; halvings < 4; ++halvings, share /= 2)
                if (const auto reached = objective (values + share * change, time); reached < best)
                {
                    best = reached;
                    values += share * change;
                    break;
                }

            if (before - best < (isLast ? leastGain + finestGain * best : roughGain * best))
                break;
        }

        return values;
    }

    const LearningParameters& all() const { return parameters; }

private:
    const PlayedRecording& recording (Eigen::Index r) const { return prior.recordings[static_cast<std::size_t> (r)]; }

    const LearningPrior& prior;
    LearningParameters parameters;
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
} // namespace

LearntModes learnModes (const ModalModel& model, const std::vector<Sensor>& sensors, const ModeSpread& deviations,
                        const std::vector<PlayedRecording>& recordings, const LearntModes* before)
{
    const auto prior = makePrior (model, sensors, deviations, recordings);
    const LearningProblem problem (prior);
    Eigen::VectorXd values = Eigen::VectorXd::Zero (problem.unknowns());
    const auto longest = longestTime (recordings);

    if (before != nullptr)
        values = valuesOf (prior, problem.all(), *before);
    else
    {
        auto time = firstTime (prior, problem.all());

        while (time < longest)
        {
            values = problem.solve (values, time, false);
            time *= lengthening;
        }
    }

    values = problem.solve (values, longest, true);
    auto linear = problem.equations (values, longest);
    factorLower (linear.matrix);
    const Eigen::VectorXd variances =
        solveFactored (linear.matrix, Eigen::MatrixXd::Identity (values.size(), values.size())).diagonal();

    const auto state = problem.state (values);
    LearntModes learnt { state.model,
                         sensors,
                         state.delays,
                         deviations.frequencies,
                         deviations.dampings,
                         std::sqrt (linear.misfit / linear.samples),
                         std::sqrt (linear.misfit / linear.signal) };

    for (std::size_t m = 0; m < sensors.size(); ++m)
        learnt.sensors[m].shapes = state.sensors.row (static_cast<Eigen::Index> (m));

    for (std::size_t p = 0; p < problem.all().modal.size(); ++p)
    {
        const auto& parameter = problem.all().modal[p];
        const auto left = std::sqrt (variances[static_cast<Eigen::Index> (p)]);

        if (parameter.kind == ParameterKind::frequency)
            learnt.frequencyDeviations[parameter.mode] *= left;
        else if (parameter.kind == ParameterKind::damping)
            learnt.dampingDeviations[parameter.mode] *= left;
    }

    return learnt;
}
} // namespace antinode
