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

LearntModes learntFrom (const LearningPrior& prior, const LearningProblem& problem, const LearningSolution& solution)
{
    const auto state = problem.state (solution.values);
    const auto left = deviationsLeft (solution.factored, problem.all().sharedEffects);
    const auto& deviations = prior.deviations;
    LearntModes learnt { prior.model,
                         prior.sensors,
                         state.delays,
                         state.distortions,
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
                         state.mixtures };
    learnt.model.angularFrequencies = state.model.angularFrequencies;
    learnt.model.dampingRatios = state.model.dampingRatios;
    learnt.model.participation = state.model.participation;
    learnt.model.shapes = mixed (prior.model.shapes, state.mixtures);
    learnt.model.slopes = mixed (prior.model.slopes, state.mixtures);

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

/** Values without what they say of a sensor. */
Eigen::VectorXd withoutSensor (Eigen::VectorXd values, const LearningParameters& parameters, Eigen::Index sensor)
{
    using Kind = SharedParameter::Kind;

    for (Eigen::Index p = 0; p < parameters.ofModes(); ++p)
        if (const auto& one = parameters.modal[static_cast<std::size_t> (p)];
            one.kind == ParameterKind::sensor && one.sensor == sensor)
            values[p] = 0;

    for (std::size_t i = 0; i < parameters.shared.size(); ++i)
        if (const auto& [kind, index] = parameters.shared[i];
            index == sensor && (kind == Kind::sensorGain || kind == Kind::sensorX || kind == Kind::sensorY))
            values[parameters.ofModes() + static_cast<Eigen::Index> (i)] = 0;

    return values;
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
    before.segment (parameters.delay (0), parameters.recordings) =
        values.segment (parameters.delay (0), parameters.recordings);
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
    auto learnt = learntFrom (prior, problem, solution);
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
