#include "ToleranceCauses.h"

#include "Prediction.h"
#include "SampledPrediction.h"
#include "StateRows.h"

#include <antinode_base/NumberText.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

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
} // namespace antinode
