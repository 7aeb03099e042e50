#include "Tolerance.h"

#include "Detuning.h"
#include "Prediction.h"
#include "StateRows.h"

#include <antinode_base/MessageText.h>
#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace antinode
{
namespace
{
/** Gauss and Hermite's rule of five points, the middle one left out: there nothing is off. Abramowitz and
   Stegun, 25.4.46, for the standard normal distribution. */
struct Node
{
    double place, share;
};

constexpr std::array<Node, 4> gaussHermite { { { 1.3556261799742659, 0.2220759220056126 },
                                               { -1.3556261799742659, 0.2220759220056126 },
                                               { 2.8569700138728056, 0.0112574113277207 },
                                               { -2.8569700138728056, 0.0112574113277207 } } };

/** What samples give every mode at the focus per unit of participation, N_m x N_b. */
Eigen::MatrixXd responsesToSamples (const ModalModel& off, const std::vector<int>& modes,
                                    const SampledVoltages& samples, double focusTime)
{
    const auto focus = std::llround ((focusTime - samples.firstTime) * samples.playback.sampleRate);
    const auto states = sampleResponses (off, modes, samples.playback, samples.values.cols(), focus);
    const Eigen::VectorXd ratio = decayRates (off).cwiseQuotient (dampedFrequencies (off));
    const Eigen::MatrixXd velocities = states.real() - ratio.asDiagonal() * states.imag();
    return velocities * samples.values.transpose();
}

/** The velocity of every mode at the focus that each ceramic alone gives it, N_m x N_b, with all frequencies and
    dampings times a factor. */
Eigen::MatrixXd velocitiesByCeramic (const ModalModel& model, const FocusDesign& design, double frequencyFactor,
                                     double dampingFactor)
{
    ModalModel off;
    off.angularFrequencies = model.angularFrequencies * frequencyFactor;
    off.dampingRatios = (model.dampingRatios * dampingFactor).cwiseMin (0.999);
    std::vector<int> modes (static_cast<std::size_t> (model.modes()));
    std::iota (modes.begin(), modes.end(), 0);
    std::vector<std::vector<Oscillation>> oscillations;

    for (const auto& oscillation : design.program.oscillations)
        oscillations.push_back ({ oscillation });

    const auto& program = design.program;
    Eigen::MatrixXd velocities = Eigen::MatrixXd::Zero (model.modes(), model.actuators());

    if (! oscillations.empty())
        velocities = rowResponses (off, rowsAt (program.focusTime, modes, ModalQuantity::velocity), oscillations, {})
                     * program.allocation.transpose();

    if (program.samples)
        velocities += responsesToSamples (off, modes, *program.samples, program.focusTime);

    return velocities.cwiseProduct (model.participation);
}

/** Modes are independent of each other, so all of them can be off at once where each is looked at alone. */
struct Changes
{
    Eigen::VectorXd each; ///< N_m: the RMS change of each mode's velocity where it alone is off.
    double together = 0;  ///< The RMS over the errors of the field's RMS where all are off by the same, m/s.
};

Changes computeChanges (const ModalModel& model, const FocusDesign& design, double frequencySpread,
                        double dampingSpread)
{
    const Eigen::VectorXd share = model.surface.areas / model.surface.areas.sum();
    const Eigen::VectorXd known = velocitiesByCeramic (model, design, 1, 1).rowwise().sum();
    Changes changes { Eigen::VectorXd::Zero (model.modes()), 0 };

    for (const auto& node : gaussHermite)
    {
        const Eigen::VectorXd change =
            velocitiesByCeramic (model, design, std::max (0.01, 1 + node.place * frequencySpread),
                                 std::max (0.01, 1 + node.place * dampingSpread))
                .rowwise()
                .sum()
            - known;
        const Eigen::VectorXd field = model.shapes * change;
        changes.each += node.share * change.cwiseAbs2();
        changes.together += node.share * share.dot (field.cwiseAbs2());
    }

    changes.each = changes.each.cwiseSqrt();
    changes.together = std::sqrt (changes.together);
    return changes;
}

void append (std::vector<ToleranceCause>& causes, ToleranceKind kind, const Eigen::VectorXd& fieldErrors)
{
    for (Eigen::Index k = 0; k < fieldErrors.size(); ++k)
        causes.push_back ({ static_cast<int> (k), kind, fieldErrors[k] });
}
} // namespace

std::vector<ToleranceCause> toleranceCauses (const ModalModel& model, const FocusDesign& design,
                                             const DetuningSpread& spread)
{
    const Eigen::VectorXd share = model.surface.areas / model.surface.areas.sum();
    const auto wanted = std::sqrt (share.dot (design.truncatedField.cwiseAbs2()));
    const Eigen::VectorXd shapeSizes = (share.transpose() * model.shapes.cwiseAbs2()).cwiseSqrt().transpose() / wanted;
    std::vector<ToleranceCause> causes;

    if (spread.frequency > 0)
        append (causes, ToleranceKind::frequency,
                computeChanges (model, design, spread.frequency, 0).each.cwiseProduct (shapeSizes));

    if (spread.damping > 0)
        append (causes, ToleranceKind::damping,
                computeChanges (model, design, 0, spread.damping).each.cwiseProduct (shapeSizes));

    if (spread.participation > 0)
        append (causes, ToleranceKind::participation,
                spread.participation
                    * velocitiesByCeramic (model, design, 1, 1).rowwise().norm().cwiseProduct (shapeSizes));

    if (spread.drift > 0)
        causes.push_back (
            { {}, ToleranceKind::drift, computeChanges (model, design, spread.drift, 0).together / wanted });

    std::stable_sort (causes.begin(), causes.end(),
                      [] (const ToleranceCause& a, const ToleranceCause& b) { return a.fieldError > b.fieldError; });
    return causes;
}

std::string causeSentence (const ToleranceCause& cause, const ModalModel& model)
{
    constexpr double percent = 100;
    const auto cost = std::round (percent * percent * cause.fieldError) / percent;
    const auto costs = " changes the field by " + inWords (cost) + " %.";

    if (! cause.mode)
        return "A drift of all frequencies alone" + costs;

    const auto mode = "Mode " + std::to_string (*cause.mode + 1) + " ("
                      + inWords (std::round (model.frequencyHz (*cause.mode))) + " Hz): its ";
    const std::array<const char*, 3> names { "frequency alone", "damping alone", "participations alone" };
    const auto isPlural = cause.kind == ToleranceKind::participation;
    return mode + names[static_cast<std::size_t> (cause.kind)]
           + (isPlural ? " change the field by " + inWords (cost) + " %." : costs);
}

namespace
{
ModalModel realModes (const ModalModel& model)
{
    requireRealModes (model, "tolerance studies");
    return withoutShapes (model);
}

Percentiles scorePercentiles (const std::vector<FocusScore>& scores, double FocusScore::*member)
{
    std::vector<double> values (scores.size());
    std::transform (scores.begin(), scores.end(), values.begin(),
                    [&] (const FocusScore& score) { return score.*member; });
    return computePercentiles (std::move (values));
}
} // namespace

Percentiles computePercentiles (std::vector<double> values)
{
    constexpr double whole = 100;
    std::sort (values.begin(), values.end());
    Percentiles result {};

    for (std::size_t i = 0; i < result.size(); ++i)
    {
        const auto place = tolerancePercents[i] / whole * static_cast<double> (values.size() - 1);
        const auto below = static_cast<std::size_t> (place);
        const auto above = std::min (below + 1, values.size() - 1);
        result[i] = std::lerp (values[below], values[above], place - std::floor (place));
    }

    return result;
}

ToleranceStudy::ToleranceStudy (const ModalModel& modelToUse, const FocusDesign& designToUse,
                                const ToleranceOptions& optionsToUse)
    : model (modelToUse), design (designToUse), options (optionsToUse), modes (realModes (modelToUse)),
      wantedPeak (largestTruncated (modelToUse, designToUse, designToUse.moments.front()))
{
}

FocusScore ToleranceStudy::scoreOn (const ModalModel& device) const
{
    const auto states = predictStates (device, design.program, design.program.focusTime);
    return scoreFocus (model, modalVelocities (device, states), design.truncatedField, wantedPeak);
}

FocusScore ToleranceStudy::draw (std::size_t number) const
{
    return scoreOn (detuned (modes, options.spread, drawSeed (options.seed, number)));
}

Tolerance ToleranceStudy::summary (std::vector<FocusScore> draws) const
{
    Tolerance tolerance;
    tolerance.options = options;
    tolerance.known = scoreOn (modes);
    tolerance.draws = std::move (draws);
    tolerance.vScore = scorePercentiles (tolerance.draws, &FocusScore::vScore);
    tolerance.fieldError = scorePercentiles (tolerance.draws, &FocusScore::fieldError);
    tolerance.peakRatio = scorePercentiles (tolerance.draws, &FocusScore::peakRatio);
    tolerance.causes = toleranceCauses (model, design, options.spread);
    return tolerance;
}

Tolerance evaluateTolerance (const ModalModel& model, const FocusDesign& design, const ToleranceOptions& options,
                             const std::function<void (double)>& progress)
{
    const ToleranceStudy study (model, design, options);
    const std::function<FocusScore (std::size_t)> draw = [&] (std::size_t number) { return study.draw (number); };
    return study.summary (evaluateCases (static_cast<std::size_t> (options.draws), draw,
                                         [&] (std::uint64_t done)
                                         { progress (static_cast<double> (done) / options.draws); }));
}

namespace
{
// What drawings, and shapes of drawings, were off plates of solid elements by. Docs/Theory.md, section 7.4.
constexpr DetuningSpread drawnSpread { 0.0015, 0.1, 0.04, 0.0015 };
constexpr DetuningSpread measuredSpread { 1e-5, 0.001, 0, 0 };
constexpr double drawnShapes = 0.04;
constexpr double shapesAtPoints = 0.04; // Of drawings, and between measured points.
constexpr int usualPoints = 6;

/** How far shapes and participations together are off, of the field. */
double shapeError (const ModeOrigin& origin)
{
    switch (origin.source)
    {
        case ModeSource::given:
            return 0;
        case ModeSource::drawn:
            return drawnShapes;
        case ModeSource::measured:
            return origin.unexplained;
        case ModeSource::retuned:
            break;
    }

    // One point gives no shapes.
    return origin.points < 2 ? drawnShapes : origin.unexplained;
}

std::string inPercent (double share)
{
    return inWords (std::round (1000 * share) / 10);
}

std::string rangeInWords (const ExpectedError& expected)
{
    const auto median = inPercent (expected.median), high = inPercent (expected.high);
    return median + (high == median ? "" : " to " + high) + " %";
}

ExpectedError errorOf (const ModalModel& model, const FocusDesign& design, const ModeOrigin& origin)
{
    constexpr int draws = 20;
    constexpr double most = 0.9;
    const ToleranceStudy study (model, design, { spreadOf (origin), draws, 1 });
    std::vector<double> errors;

    for (std::size_t i = 0; i < draws; ++i)
        errors.push_back (std::hypot (study.draw (i).fieldError, shapeError (origin)));

    std::sort (errors.begin(), errors.end());
    return { errors[draws / 2], errors[static_cast<std::size_t> (most * draws)], {} };
}

/** Where the modes come from, and what makes them better. */
std::string originInWords (const ModalModel& model, const FocusDesign& design)
{
    const auto& origin = model.origin;
    const auto points = std::to_string (origin.points) + " points";

    switch (origin.source)
    {
        case ModeSource::given:
            return "the device does not record how its modes were found";
        case ModeSource::measured:
            return "measured at " + points;
        case ModeSource::retuned:
            return "drawn, retuned at " + points + "; 'antinode identify' measures shapes, too";
        case ModeSource::drawn:
            break;
    }

    const auto retuned = errorOf (model, design, { ModeSource::retuned, usualPoints, drawnShapes, true });
    return "drawn, with materials as stated, not measured; 'antinode retune' with " + std::to_string (usualPoints)
           + " measured points brings " + rangeInWords (retuned);
}
} // namespace

DetuningSpread spreadOf (const ModeOrigin& origin)
{
    switch (origin.source)
    {
        case ModeSource::drawn:
            return drawnSpread;
        case ModeSource::retuned:
        case ModeSource::measured:
            return measuredSpread;
        case ModeSource::given:
            break;
    }

    return usualSpread;
}

std::optional<ExpectedError> expectedError (const ModalModel& model, const FocusDesign& design)
{
    if (model.hasComplexModes())
        return {};

    auto expected = errorOf (model, design, model.origin);
    expected.sentence = "expect " + rangeInWords (expected) + " (" + originInWords (model, design) + ")";
    return expected;
}

ModalModel likelyDevice (const ModalModel& model, std::uint64_t number)
{
    auto device = detuned (model, spreadOf (model.origin), drawSeed (1, number));
    // A factor of each mode: that of a damping ratio which nothing uses.
    const auto factors = detuned (withoutShapes (model), { 0, shapesAtPoints, 0, 0 }, drawSeed (2, number));

    for (Eigen::Index c = 0; c < device.coordinates(); ++c)
    {
        const auto k = c % device.modes();
        device.participation.row (c) *= factors.dampingRatios[k] / model.dampingRatios[k];
    }

    return device;
}
} // namespace antinode
