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

/** Raises what is believed of the noise to what values leave unexplained: neither tells of the parameters.
    @param stated  what the recordings say of it, of each
    @return        whether any sensor's changes by much */
bool believeWhatIsLeft (LearningPrior& prior, const std::vector<Eigen::VectorXd>& stated,
                        const std::vector<Eigen::VectorXd>& left)
{
    constexpr double much = 1.2; // times
    auto changes = false;

    for (std::size_t r = 0; r < left.size(); ++r)
    {
        const Eigen::VectorXd believed = left[r].cwiseMax (stated[r]);
        const Eigen::ArrayXd ratios = believed.array() / prior.noise[r].array();
        changes = changes || (ratios > much).any() || (ratios < 1 / much).any();
        prior.noise[r] = believed;
    }

    return changes;
}

/** Holds sensors back in turn: what the others learn predicts each as well as the device as it was, or better. */
void holdBack (LearntModes& learnt, LearningPrior& prior, const LearningProblem& problem, const Eigen::VectorXd& values,
               double longest)
{
    constexpr Eigen::Index most = 4; // sensors, evenly among all
    constexpr double deaf = 1e6;     // times the noise
    const auto sensors = std::ssize (prior.sensors);

    if (sensors < 2 || prior.sensors.front().deviations.size() == 0)
        return;

    const auto& parameters = problem.all().parameters;
    Eigen::VectorXd before = Eigen::VectorXd::Zero (values.size());
    before.segment (parameters.delay (0), parameters.delays) = values.segment (parameters.delay (0), parameters.delays);
    const auto count = std::min (sensors, most);
    const auto believed = prior.noise;

    for (Eigen::Index i = 0; i < count; ++i)
    {
        const auto held = i * sensors / count;

        for (auto& noise : prior.noise)
            noise[held] *= deaf;

        const auto others = problem.solve (problem.clearlyHeard(), withoutSensor (values, parameters, held), longest,
                                           roughGain, unbounded);
        prior.noise = believed;
        const auto share = [&] (const Eigen::VectorXd& at) { return problem.unexplainedShare (at, held, longest); };
        learnt.heldBack += share (withoutSensor (others.values, parameters, held)) / static_cast<double> (count);
        learnt.heldBackBefore += share (before) / static_cast<double> (count);
    }

    learnt.heldBack = std::sqrt (learnt.heldBack);
    learnt.heldBackBefore = std::sqrt (learnt.heldBackBefore);
}

/** The device by the most probable values, where what no parameter explains is noise, too. */
LearntModes settled (LearningPrior& prior, const LearningProblem& problem, LearningSolution solution, double longest)
{
    constexpr int mostTimes = 4;
    const auto stated = prior.noise;

    for (int i = 0; i < mostTimes && believeWhatIsLeft (prior, stated, problem.noiseLeft (solution.values, longest));
         ++i)
        solution = problem.finish (std::move (solution.values), longest);

    const auto believed = std::exchange (prior.noise, stated);
    solution = problem.judged (std::move (solution), longest);
    auto learnt = problem.learnt (solution);
    prior.noise = believed;
    holdBack (learnt, prior, problem, solution.values, longest);
    return learnt;
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
    auto prior = makePrior (model, sensors, deviations, recordings);
    const LearningProblem problem (prior);
    const auto longest = longestTime (recordings);

    if (before != nullptr)
    {
        auto values = valuesOf (prior, problem.all().parameters, *before);
        values =
            problem.solve (problem.clearlyHeard(), std::move (values), longest, LearningProblem::finestGain, unbounded)
                .values;
        return settled (prior, problem, problem.finish (std::move (values), longest), longest);
    }

    return settled (prior, problem, fromTheBeginning (prior, problem, longest), longest);
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
