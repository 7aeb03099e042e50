#include "PlacedDesigns.h"

#include "DriveAllocation.h"
#include "FeltLevels.h"
#include "ModeDrives.h"
#include "ModeWeighing.h"
#include "Projection.h"
#include "StateRows.h"
#include "TargetField.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_model/RigidMotion.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace antinode
{
namespace
{
using Indices = std::vector<Eigen::Index>;

/** Thrown through weighModes, which must not take it for a design that cannot be: the whole solver is needed. */
class NeedsSolver
{
};

constexpr std::array multiplesAtRest { 1.1, 1.25, 1.5, 2.0 }; // as designWithin
constexpr double worthwhileRest = 0.9;

/** Without points: choices of modes look at velocities and participations alone. */
ModalModel withoutPoints (const ModalModel& model, Eigen::Index count)
{
    ModalModel modes;
    modes.name = model.name;
    modes.ceramics = model.ceramics;
    modes.angularFrequencies = model.angularFrequencies.head (count);
    modes.dampingRatios = model.dampingRatios.head (count);
    modes.participation = model.participation.topRows (count);
    modes.shapes.resize (0, count);
    modes.surface.masses.resize (0);
    return modes;
}

std::vector<int> allModes (Eigen::Index count)
{
    std::vector<int> all (static_cast<std::size_t> (count));
    std::iota (all.begin(), all.end(), 0);
    return all;
}

/** Of each mode alone; those that have none are left empty. */
std::vector<std::vector<Oscillation>> drivesOf (const ModalModel& model, double time, const TransientChoice& choice)
{
    std::vector<std::vector<Oscillation>> drives;

    for (const auto mode : allModes (model.modes()))
    {
        checkWatch();

        try
        {
            drives.push_back (driveModes (model, { mode }, time, choice).front().oscillations);
        }
        catch (const InputError&)
        {
            drives.emplace_back(); // Who controls this mode is told why by the whole solver.
        }
    }

    return drives;
}

double earliestStart (const std::vector<std::vector<Oscillation>>& drives, double time)
{
    for (const auto& drive : drives)
        if (! drive.empty())
            time = std::min (time, drive.front().start);

    return time;
}

/** shapes' areas shapes, in pieces: shapes of plates are large. */
Eigen::MatrixXd overlapsOnSurface (const ModalModel& model)
{
    constexpr Eigen::Index pointsAtOnce = 1024;
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero (model.modes(), model.modes());

    for (Eigen::Index first = 0; first < model.points(); first += pointsAtOnce)
    {
        const auto count = std::min (pointsAtOnce, model.points() - first);
        const Eigen::MatrixXd shapes = model.shapes.middleRows (first, count);
        addTransposedLeft (sums, 1, shapes, model.surface.areas.segment (first, count).asDiagonal() * shapes);
    }

    return sums;
}

/** Rows of a Gram matrix brought to a diagonal of 1. */
Eigen::VectorXd scaleOf (const Eigen::MatrixXd& gram)
{
    return gram.diagonal().cwiseSqrt().cwiseInverse();
}

/** The largest magnitude in each column of the chosen columns of samples times shares, in pieces: a copy of all chosen
    samples would cost more than the product. */
Eigen::VectorXd peaksOf (const Eigen::MatrixXd& samples, const std::vector<int>& chosen, const Eigen::MatrixXd& shares)
{
    constexpr Eigen::Index samplesAtOnce = 256;
    Eigen::VectorXd peaks = Eigen::VectorXd::Zero (shares.cols());

    for (Eigen::Index first = 0; first < samples.rows(); first += samplesAtOnce)
    {
        const auto count = std::min (samplesAtOnce, samples.rows() - first);
        Eigen::MatrixXd values = Eigen::MatrixXd::Zero (count, shares.cols());
        addProduct (values, 1, samples.middleRows (first, count) (Eigen::all, chosen), shares);
        peaks = peaks.cwiseMax (values.cwiseAbs().colwise().maxCoeff().transpose());
    }

    return peaks;
}
} // namespace

struct PlacedDesigns::Trial
{
    FocusDesign design;
    Eigen::VectorXd velocities;
};

bool PlacedDesigns::suits (const WideModel& wide, const FocusDescription& focus)
{
    const auto& model = wide.model;
    const auto& choice = focus.allocation;
    const auto isOneMoment = std::none_of (focus.targets.begin(), focus.targets.end(),
                                           [] (const auto& target) { return target.time.has_value(); });
    return ! model.hasComplexModes() && model.coversWholeBody && resolvedModes (model) == model.modes() && isOneMoment
           && focus.fingers.empty() && ! focus.felt && ! asksForLevels (focus) && ! hasSlewLimits (model)
           && choice.method == AllocationMethod::exact && ! choice.window && ! choice.isUndisplaced && ! choice.robust
           && focus.transients.growth.empty() && focus.transients.cycles.empty() && suspensionModes (model) == 0;
}

PlacedDesigns::PlacedDesigns (const WideModel& wide, const FocusDescription& focus, Playback playbackToUse)
    : description (focus), playback (playbackToUse), known (wide.known),
      time (focusMoments (firstModes (wide.model, wide.known), focus, playbackToUse).front().time),
      modes (withoutPoints (wide.model, wide.model.modes())), ownModes (withoutPoints (wide.model, wide.known)),
      drives (drivesOf (ownModes, time, focus.transients)), shapeOverlaps (overlapsOnSurface (wide.model)),
      fullLimits (voltageLimits (wide.model, focus.allocation))
{
    limits = fullLimits * gridLimitMargin();
    samples = sampleDrives (drives, earliestStart (drives, time), time + releaseDuration()).transpose();
    lengths = samples.colwise().norm().transpose();
    lengths = (lengths.array() > 0).select (lengths, 1);
    samples *= lengths.cwiseInverse().asDiagonal();
    overlaps = Eigen::MatrixXd::Zero (known, known);
    addTransposedLeft (overlaps, 1, samples, samples);
    responses =
        rowResponses (modes, rowsAt (time, allModes (modes.modes()), ModalQuantity::velocity), drives, playback);
    responses *= lengths.cwiseInverse().asDiagonal();
    participationGram = Eigen::MatrixXd::Zero (modes.modes(), modes.modes());
    addTransposedRight (participationGram, 1, modes.participation, modes.participation);
}

FocusDesign PlacedDesigns::chosen (const ProjectedTarget& target, const ModeChoice& choice) const
{
    auto among = choice;
    among.among = static_cast<int> (known);
    const auto selection = selectModes (ownModes, target, among);
    FocusDesign design;
    design.description = description;
    design.playback = playback;
    design.controlledModes = selection.modes;
    design.captured = selection.captured;
    design.residue = std::sqrt (1 - selection.captured * selection.captured);
    FocusMoment moment;
    moment.time = time;
    moment.targets = description.targets;
    moment.target = target;
    moment.wanted = selection.wanted;
    moment.captured = selection.captured;
    design.moments = { std::move (moment) };
    return design;
}

Eigen::MatrixXd PlacedDesigns::sharesOf (const FocusDesign& design, Eigen::Index designed) const
{
    constexpr double dependence = 1e-5, smallestDistance = 1e-6, shift = 1e-13, minimumCompliance = 1e-12;
    const auto& choice = description.allocation;
    const Indices controlled (design.controlledModes.begin(), design.controlledModes.end());
    const auto& wanted = design.moments.front().wanted;

    // Wanted velocities and rest beyond the device's own modes are hard rows, the others guards.
    auto rows = controlled;

    for (auto beyond = known; beyond < designed; ++beyond)
        rows.push_back (beyond);

    const auto hard = static_cast<Eigen::Index> (rows.size());

    if (choice.guardWeight > 0)
        for (const auto guard : guardModes (ownModes, design.controlledModes, choice))
            if (participationGram (guard, guard) > 0)
                rows.push_back (guard);

    Eigen::MatrixXd factor = overlaps (controlled, controlled);

    if (! factorLower (factor) || ! (factor.diagonal().minCoeff() > dependence))
        throw NeedsSolver();

    Eigen::MatrixXd seen = responses (rows, controlled);
    solveLowerTransposedFromRight (factor, seen);
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero (seen.rows(), seen.rows());
    addTransposedRight (gram, 1, seen, seen);
    gram.array() *= participationGram (rows, rows).array();

    if (! (gram.diagonal().minCoeff() > 0))
        throw NeedsSolver();

    const auto scale = scaleOf (gram);
    gram = (scale.asDiagonal() * gram * scale.asDiagonal()).eval();
    Eigen::VectorXd right = Eigen::VectorXd::Zero (gram.rows());
    right.head (wanted.size()) = scale.head (wanted.size()).cwiseProduct (wanted);
    Eigen::MatrixXd hardGram = gram.topLeftCorner (hard, hard);
    hardGram.diagonal().array() += shift;

    if (! factorLower (hardGram) || ! (hardGram.diagonal().minCoeff() > smallestDistance))
        throw NeedsSolver();

    const auto energy = right.head (hard).dot (solveFactored (hardGram, right.head (hard)).col (0));
    const auto stiffness = choice.guardWeight * energy / wanted.squaredNorm();

    for (auto r = hard; r < gram.rows(); ++r)
        gram (r, r) += std::max (scale[r] * scale[r] / stiffness, minimumCompliance);

    if (! factorLower (gram))
        throw NeedsSolver();

    const Eigen::VectorXd multipliers = scale.cwiseProduct (solveFactored (gram, right).col (0));
    Eigen::MatrixXd shares = Eigen::MatrixXd::Zero (wanted.size(), modes.actuators());
    addTransposedLeft (shares, 1, seen, multipliers.asDiagonal() * modes.participation (rows, Eigen::all));
    solveLowerTransposed (factor, shares);
    return shares;
}

PlacedDesigns::Trial PlacedDesigns::allocated (FocusDesign design, Eigen::Index designed) const
{
    constexpr double accurate = 1e-7;
    checkWatch();
    const auto& controlled = design.controlledModes;
    const auto& wanted = design.moments.front().wanted;

    for (const auto mode : controlled)
        if (drives[static_cast<std::size_t> (mode)].empty()
            || (playback.sampleRate > 0 && modes.frequencyHz (mode) >= 0.5 * playback.sampleRate))
            throw NeedsSolver();

    const auto shares = sharesOf (design, designed);
    const auto peaks = peaksOf (samples, controlled, shares);
    auto& certificate = design.certificate;
    certificate.peakVoltage = peaks.maxCoeff();
    certificate.peakRatio = peaks.cwiseQuotient (limits).maxCoeff();

    if (! (certificate.peakRatio <= 1))
        throw NeedsSolver();

    Eigen::MatrixXd moved = Eigen::MatrixXd::Zero (modes.modes(), shares.cols());
    addProduct (moved, 1, responses (Eigen::all, controlled), shares);
    Trial trial;
    trial.velocities = moved.cwiseProduct (modes.participation).rowwise().sum();
    certificate.rowResidual =
        (trial.velocities (controlled) - wanted).cwiseAbs().maxCoeff() / wanted.cwiseAbs().maxCoeff();

    if (! (certificate.rowResidual <= accurate))
        throw NeedsSolver();

    DriveList played;

    for (const auto mode : controlled)
        played.push_back (drives[static_cast<std::size_t> (mode)]);

    const Eigen::MatrixXd matrix = (lengths (controlled).cwiseInverse().asDiagonal() * shares).transpose();
    design.program = makeProgram (played, matrix, fullLimits, time);
    trial.design = std::move (design);
    return trial;
}

PlacedDesigns::Trial PlacedDesigns::weighed (const ProjectedTarget& target, Eigen::Index designed) const
{
    if (! leavesModesOpen (description))
        return allocated (chosen (target, description.modes), designed);

    std::vector<Trial> made;
    const auto allocate = [&] (FocusDesign design)
    {
        made.push_back (allocated (std::move (design), designed));
        return made.back().design;
    };
    const auto best =
        weighModes (ownModes, { [&] (const ModeChoice& choice) { return chosen (target, choice); }, allocate });
    const auto same = [&] (const Trial& trial) { return trial.design.controlledModes == best.controlledModes; };
    return std::move (*std::find_if (made.begin(), made.end(), same));
}

/** As spillOverShare: of the field on the surface. */
double PlacedDesigns::shareBeyond (const Eigen::VectorXd& velocities) const
{
    const auto beyond = modes.modes() - known;
    const auto outside = velocities.tail (beyond);
    const auto whole = velocities.dot (shapeOverlaps * velocities);
    return whole > 0 ? std::sqrt (outside.dot (shapeOverlaps.bottomRightCorner (beyond, beyond) * outside) / whole) : 0;
}

/** As largestFieldError. */
double PlacedDesigns::fieldError (const Trial& trial) const
{
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero (modes.modes());
    wanted (trial.design.controlledModes) = trial.design.moments.front().wanted;
    const Eigen::VectorXd wrong = trial.velocities - wanted;
    return std::sqrt (wrong.dot (shapeOverlaps * wrong) / wanted.dot (shapeOverlaps * wanted));
}

std::optional<PlacedDesign> PlacedDesigns::design (const ProjectedTarget& target) const
{
    try
    {
        auto best = weighed (target, known);

        for (const auto multiple : multiplesAtRest)
        {
            const auto designed = static_cast<Eigen::Index> (std::ceil (multiple * static_cast<double> (known)));

            if (shareBeyond (best.velocities) <= allowedSpillOver || designed > modes.modes())
                break;

            auto next = weighed (target, designed);

            if (shareBeyond (next.velocities) < worthwhileRest * shareBeyond (best.velocities)
                && fieldError (next) <= fieldError (best))
                best = std::move (next);
        }

        return PlacedDesign { std::move (best.design), std::move (best.velocities) };
    }
    catch (const NeedsSolver&)
    {
        return {};
    }
}
} // namespace antinode
