#include "Retuning.h"

#include "LearningEquations.h"
#include "LearningProblem.h"
#include "ModeSpread.h"

#include <antinode_base/InputError.h>
#include <antinode_identification/Comparison.h>
#include <antinode_identification/FitErrors.h>
#include <antinode_identification/KnownModeFit.h>
#include <antinode_identification/KnownModes.h>
#include <antinode_model/ModalModel.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
using Indices = std::vector<Eigen::Index>;

constexpr double reachOutside = 0.1; ///< Relative: modes so far outside the band may have drifted into it.

void check (const ModalModel& model, const FrequencyResponses& responses)
{
    if (responses.drive != DriveQuantity::voltage)
        throw InputError ("frequency responses",
                          "are per force; allowed: responses to voltages of the device's ceramics");

    if (static_cast<Eigen::Index> (responses.references.size()) != model.actuators())
        throw InputError ("frequency responses", "have " + std::to_string (responses.references.size())
                                                     + " references; allowed: the " + std::to_string (model.actuators())
                                                     + " ceramics of device '" + model.name + "'");
}

/** The modes that the measured band can say anything of; those that no ceramic drives are not heard. */
Indices modesNear (const ModalModel& model, const PreparedResponses& data)
{
    const auto lowest = data.omega[0] * (1 - reachOutside), highest = data.omega[data.lines() - 1] * (1 + reachOutside);
    Indices result;

    for (Eigen::Index k = 0; k < model.modes(); ++k)
        if (const auto omega = model.angularFrequencies[k];
            omega > lowest && omega < highest && model.participation.row (k).squaredNorm() > 0)
            result.push_back (k);

    if (result.empty())
        throw InputError ("frequency responses", "contain no mode of device '" + model.name + "'");

    return result;
}

/** Hz: above it the device may have modes that the model does not, which known ones would be taken for: half of the
    spacing above the last mode, or where the next one may have come down to. */
double highestLine (const ModalModel& model, const KnownSpread& spread)
{
    constexpr double farthest = 2;     // deviations
    constexpr double leastLeft = 0.75; // of the model's range, however little is known
    const auto last = model.modes() - 1, several = std::min<Eigen::Index> (5, last);

    if (several < 1)
        return 1e12;

    const auto highest = model.angularFrequencies[last];
    const auto spacing = (highest - model.angularFrequencies[last - several]) / static_cast<double> (several);
    const auto next = (highest + spacing) * std::max (leastLeft, 1 - farthest * spread.frequency);
    return std::min (highest + spacing / 2, next) / (2 * std::numbers::pi);
}

ModeSpread deviationsOf (const ModalModel& model, const KnownSpread& spread)
{
    const auto usual = usualDeviations (model);
    auto deviations = sameSpread (model.modes(), spread.frequency, spread.damping, spread.participation);
    deviations.mixing = usual.mixing;
    deviations.mixesForces = usual.mixesForces;
    deviations.ceramicGains = 0.2;
    // Where the model has a node, a device has about this much of what the mode's other ceramics have.
    deviations.atNodes = 0.2;
    deviations.delay = 1; // s: as good as not known
    deviations.distortion = 0;
    return deviations;
}

/** Of many points the shapes' errors even out, and those that each has would be unknowns without end. */
std::vector<Sensor> sensorsAt (const ModalModel& model, const Eigen::MatrixX2d& points, double placeDeviation)
{
    constexpr Eigen::Index many = 30;
    const auto shapes = shapesAtPlaces (model, points);
    std::vector<Sensor> sensors;
    sensors.reserve (static_cast<std::size_t> (points.rows()));

    for (Eigen::Index p = 0; p < points.rows(); ++p)
        sensors.push_back (points.rows() > many ? Sensor { shapes.row (p) }
                                                : sensorAt (model, points (p, 0), points (p, 1), placeDeviation));

    return sensors;
}

/** Modes as responses and what was known before say that they are. */
struct Fit
{
    LearntModes learnt;
    Eigen::VectorXd pointErrors; ///< N_p: what each point's place in the file leaves of its responses, RMS over RMS.
    double unexplained = 0;      ///< RMS over RMS.
    double shapeError = 0;       ///< Of the middle mode at the points, RMS over RMS.
    bool hasExactShapes = false; ///< Shapes and places were not fitted.
};

/** How far shapes of the middle mode are off at the points, RMS over RMS: what was found of each beside what all
    share. */
double shapeErrorOf (const LearningPrior& prior, const LearningParameters& parameters, const Eigen::VectorXd& values)
{
    Eigen::VectorXd errors = Eigen::VectorXd::Zero (prior.model.modes()), shapes = errors;

    for (const auto& sensor : prior.sensors)
        shapes += sensor.shapes.cwiseAbs2().transpose();

    for (Eigen::Index p = 0; p < parameters.ofModes(); ++p)
        if (const auto& [kind, mode, m, ceramics, information] = parameters.modal[static_cast<std::size_t> (p)];
            kind == ParameterKind::sensor)
            errors[mode] += std::pow (values[p] * prior.sensors[static_cast<std::size_t> (m)].deviations[mode], 2);

    const Eigen::VectorXd shares = errors.cwiseQuotient (shapes.cwiseMax (1e-300)).cwiseSqrt();
    return median ({ shares.begin(), shares.end() });
}

/** Errors as white noise of which each line would tell as little: what goes on over many lines, as modes beyond the
    model do, counts once. */
Eigen::MatrixXd independently (const FitErrors& errors)
{
    const Eigen::ArrayXXd energies = errors.energies.array(), rough = errors.roughness.array().max (1e-3 * energies);
    // The correlation of neighbouring lines is 1 - rough / energies.
    return (energies * (2 * energies / rough - 1).max (1)).matrix();
}

/** The most probable values, under weights and a noise that follow what they leave.
    @param start  poles as they were found, on the way to them */
Fit fitted (const LearningPrior& prior, const LearningProblem& problem, const LearntModes& start)
{
    constexpr double roughly = 1e-5, unbounded = 1e9, much = 1.2;
    constexpr int mostTimes = 4;
    auto& responses = *prior.responses;
    LearningSolution solution { valuesOf (prior, problem.all().parameters, start), {}, 0, 0, 0, 0 };
    auto end = responseState (prior, problem.state (solution.values));
    responses.variance = end.variance();

    for (int i = 0; i < mostTimes; ++i)
    {
        const auto before = end.variance();
        solution = problem.solve (problem.all(), std::move (solution.values), 0, i == 0 ? roughly : 0, unbounded);
        const auto now = problem.state (solution.values);
        const auto delay = now.delays[now.delays.size() - 1];
        end = responseState (prior, now);
        auto errors = fitErrors (responses.data, end.basis, end.coefficients, delay);
        errors.roughness = independently (errors);
        weighByErrors (responses.data, errors);
        responses.moments = lineMoments (responses.data, delay);
        end = responseState (prior, now);
        responses.variance = responses.data.responses->variances.empty() ? 1 : end.variance();
        const auto ratio = end.variance() / before;

        if (i > 0 && ratio < much && ratio > 1 / much)
            break;
    }

    // A point that was turned over or is elsewhere is fitted, too: it is told by its place in the file.
    auto stated = solution.values;

    for (Eigen::Index m = 0; m < std::ssize (prior.sensors); ++m)
        stated = withoutSensor (std::move (stated), problem.all().parameters, m);

    const auto pointErrors = responseState (prior, problem.state (stated)).pointErrors;
    const auto shapeError = shapeErrorOf (prior, problem.all().parameters, solution.values);
    return { problem.learnt (problem.judged (std::move (solution), 0)), pointErrors, std::sqrt (end.left / end.energy),
             shapeError, prior.sensors.front().deviations.size() == 0 };
}

/** @param nominal  modes near the lines, with their common drift */
Fit fittedWithShapes (const ModalModel& nominal, PreparedResponses& data, const KnownPoles& poles,
                      const KnownSpread& spread, double placeDeviation)
{
    const auto sensors = sensorsAt (nominal, data.responses->points, placeDeviation);
    const auto deviations = deviationsOf (nominal, spread);
    const std::vector<PlayedRecording> none;
    HeardResponses heard { data, poles.delay };
    const auto prior = makePrior (nominal, sensors, deviations, none, &heard);
    LearntModes start;
    start.model = nominal;
    start.sensors = sensors;
    start.delays = prior.delays();
    start.model.angularFrequencies = poles.angularFrequencies;
    start.model.dampingRatios = poles.dampingRatios;
    return fitted (prior, LearningProblem (prior), start);
}

KnownModePrior priorOf (const KnownModes& known, const KnownSpread& spread)
{
    // Where the model has a node, a device has about this much of what the mode's other ceramics have.
    constexpr double leastOfOthers = 0.2;
    const Eigen::VectorXd others = leastOfOthers * known.participation.rowwise().norm()
                                   / std::sqrt (static_cast<double> (known.participation.cols()));
    Eigen::MatrixXd spreads (known.participation.rows(), known.participation.cols());

    for (Eigen::Index i = 0; i < spreads.cols(); ++i)
        spreads.col (i) =
            spread.participation * (known.participation.col (i).cwiseAbs2() + others.cwiseAbs2()).cwiseSqrt();

    return { known.angularFrequencies, Eigen::VectorXd::Constant (known.modes(), spread.frequency),
             known.dampingRatios,      spread.damping,
             known.participation,      spreads };
}

/** With shapes as they are known: of hundreds of modes that overlap, theirs would be unknowns without end. */
Fit fittedByShapes (const ModalModel& nominal, PreparedResponses& data, const KnownPoles& poles,
                    const KnownSpread& spread)
{
    const KnownModes known { nominal.angularFrequencies, nominal.dampingRatios,
                             shapesAtPlaces (nominal, data.responses->points), nominal.participation };
    auto start = known;
    start.angularFrequencies = poles.angularFrequencies;
    start.dampingRatios = poles.dampingRatios;
    auto found = fitKnownModes (data, start, priorOf (known, spread), poles.delay);
    Fit fit;
    fit.hasExactShapes = true;
    fit.learnt.model = nominal;
    fit.learnt.model.angularFrequencies = std::move (found.modes.angularFrequencies);
    fit.learnt.model.dampingRatios = std::move (found.modes.dampingRatios);
    fit.learnt.model.participation = std::move (found.modes.participation);
    fit.learnt.delays = Eigen::VectorXd::Constant (1, found.delay);
    fit.learnt.frequencyDeviations = std::move (found.frequencyDeviations);
    fit.learnt.dampingDeviations = std::move (found.dampingDeviations);
    fit.learnt.participationDeviations = std::move (found.participationDeviations);
    fit.pointErrors = std::move (found.pointErrors);
    fit.unexplained = std::pow (10.0, std::min (0.0, found.reconstructionError) / 20);
    return fit;
}

/** What was fitted of some modes, put into the whole device. */
RetunedModel retuned (const ModalModel& model, const Indices& modes, const Fit& fit, const KnownPoles& poles,
                      const KnownSpread& spread, double highest)
{
    constexpr double seen = 0.5; // of what was not known before
    constexpr double beside = 2; // half widths of a mode that have to be below the highest line
    const auto all = model.modes();
    ModeUpdate update { Eigen::VectorXd::Zero (all), Eigen::VectorXd::Zero (all),
                        std::vector<bool> (static_cast<std::size_t> (all)) };
    RetunedModel result;
    result.frequencyDeviations.setConstant (all, spread.frequency);
    result.dampingDeviations.setConstant (all, spread.damping);
    result.participationDeviations.setConstant (all, spread.participation);
    const auto& now = fit.learnt;
    const auto scales = scalesOf (now.model.participation, model.participation (modes, Eigen::all));
    auto participation = model.participation;
    participation *= scales.asDiagonal();
    auto shapes = model.shapes;
    auto slopes = model.slopes;

    for (std::size_t n = 0; n < modes.size(); ++n)
    {
        const auto k = modes[n], of = static_cast<Eigen::Index> (n);
        const auto upperEnd = now.model.angularFrequencies[of] * (1 + beside * now.model.dampingRatios[of]);

        if (poles.gains[of] <= 0 || now.frequencyDeviations[of] > seen * spread.frequency
            || upperEnd > 2 * std::numbers::pi * highest)
            continue;

        update.isKnown[static_cast<std::size_t> (k)] = true;
        update.angularFrequencies[k] = now.model.angularFrequencies[of];
        update.dampingRatios[k] = now.model.dampingRatios[of];
        participation.row (k) = now.model.participation.row (of);
        shapes.col (k) = now.model.shapes.col (of);

        if (slopes.size() > 0)
            slopes.col (k) = now.model.slopes.col (of);

        result.frequencyDeviations[k] = now.frequencyDeviations[of];
        result.dampingDeviations[k] = now.dampingDeviations[of];
        result.participationDeviations[k] = now.participationDeviations[of];
    }

    if (std::none_of (update.isKnown.begin(), update.isKnown.end(), [] (bool isKnown) { return isKnown; }))
        throw InputError ("frequency responses", "contain no mode of device '" + model.name + "'");

    auto changed = updated (model, update);
    changed.participation = participation;
    changed.shapes = std::move (shapes);
    changed.slopes = std::move (slopes);

    if (changed.staticShare.size() > 0)
        changed.staticShare *= scales.asDiagonal();

    result.found = update.isKnown;
    result.frequencyChanges = (changed.angularFrequencies.array() / model.angularFrequencies.array() - 1).matrix();
    result.dampingChanges = (changed.dampingRatios.array() / model.dampingRatios.array() - 1).matrix();
    result.participationScales = scales;
    result.reconstructionError = 20 * std::log10 (fit.unexplained);
    changed.origin = { ModeSource::retuned, static_cast<int> (fit.pointErrors.size()),
                       std::min (1.0, std::hypot (fit.unexplained, fit.shapeError)), model.origin.scaleIsKnown };

    if (model.origin.source == ModeSource::measured)
        changed.origin.source = ModeSource::measured;

    result.model = ascending (std::move (changed));
    result.pointErrors = fit.pointErrors;
    result.hasExactShapes = fit.hasExactShapes;
    result.delay = now.delays[now.delays.size() - 1];
    return result;
}
} // namespace

RetunedModel retune (const ModalModel& model, const FrequencyResponses& responses, const KnownSpread& spread,
                     double placeDeviation)
{
    requireRealModes (model, "updates of modes by new measurements");
    validate (responses);
    check (model, responses);
    auto highest = highestLine (model, spread);
    auto data = prepare (responses, 0, highest);
    const auto modes = modesNear (model, data);
    auto nominal = withModes (model, modes);
    const KnownModes known { nominal.angularFrequencies, nominal.dampingRatios,
                             shapesAtPlaces (nominal, responses.points), nominal.participation };
    const auto poles = findKnownPoles (data, known, spread);
    // Modes beyond the model have drifted with the others.
    highest *= poles.drift;
    nominal.angularFrequencies *= poles.drift;
    data = prepare (responses, 0, highest);
    constexpr Eigen::Index mostUnknowns = 4000; // of a step, which costs with their cube
    const auto unknowns = nominal.modes() * (2 + nominal.actuators() + responses.points.rows());
    const auto fit = unknowns <= mostUnknowns ? fittedWithShapes (nominal, data, poles, spread, placeDeviation)
                                              : fittedByShapes (nominal, data, poles, spread);
    return retuned (model, modes, fit, poles, spread, highest);
}
} // namespace antinode
