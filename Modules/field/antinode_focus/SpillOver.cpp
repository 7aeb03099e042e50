#include "SpillOver.h"

#include "DesignFocus.h"
#include "FocusScore.h"
#include "Prediction.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_fingers/LoadedModel.h>
#include <antinode_fingers/OneSidedContact.h>
#include <antinode_model/ShapeInterpolation.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
constexpr double sameFrequency = 0.01;                            // Two solutions of one device agree far better.
constexpr double worthwhileShare = 0.9;                           // Less is not gained for more guards.
constexpr std::array triedGuards { 1.1, 1.25, 1.5, 2.0 };         // Times the known modes.
constexpr std::array triedOfSamples { 1.1, 1.25, 1.5, 2.0, 2.5 }; // Of samples, which reach up to half their rate.

/** Values at the points of one grid taken to those of another, column by column. */
Eigen::MatrixXd regridded (const PlateGrid& from, const PlateGrid& to, const Eigen::MatrixXd& values)
{
    const auto rowsX = interpolationRows (from.x, to.x.places);
    const auto rowsY = interpolationRows (from.y, to.y.places);
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (rowsX.rows() * rowsY.rows(), values.cols());
    Eigen::MatrixXd half;

    for (Eigen::Index k = 0; k < values.cols(); ++k)
    {
        const Eigen::MatrixXd before =
            Eigen::Map<const Eigen::MatrixXd> (values.col (k).data(), rowsX.cols(), rowsY.cols());
        half.setZero (rowsX.rows(), rowsY.cols());
        addProduct (half, 1, rowsX, before);
        addTransposedRight (Eigen::Map<Eigen::MatrixXd> (result.col (k).data(), rowsX.rows(), rowsY.rows()), 1, half,
                            rowsY);
    }

    return result;
}

void appendColumns (Eigen::MatrixXd& all, const Eigen::MatrixXd& more)
{
    const auto before = all.cols();
    all.conservativeResize (Eigen::NoChange, before + more.cols());
    all.rightCols (more.cols()) = more;
}

void appendRows (Eigen::VectorXd& all, const Eigen::VectorXd& more)
{
    all.conservativeResize (all.size() + more.size());
    all.tail (more.size()) = more;
}

void appendShapes (ModalModel& model, const ModalModel& wide, Eigen::Index count)
{
    if (wide.surface.points.rows() == model.points() && wide.surface.points == model.surface.points)
    {
        appendColumns (model.shapes, wide.shapes.rightCols (count));

        if (model.slopes.size() > 0)
            appendColumns (model.slopes, wide.slopes.rightCols (count));

        return;
    }

    if (model.surface.boundary)
        throw InputError ("device '" + model.name + "'", "has other points in its second solution");

    if (model.surface.grid)
    {
        appendColumns (model.shapes,
                       regridded (wide.surface.grid.value(), *model.surface.grid, wide.shapes.rightCols (count)));
        return;
    }

    const Eigen::VectorXd from = wide.surface.points.col (0);
    const Eigen::MatrixXd values = wide.shapes.rightCols (count), slopes = wide.slopes.rightCols (count);
    Eigen::MatrixXd moreShapes (model.points(), count), moreSlopes (model.points(), count);

    for (Eigen::Index i = 0; i < model.points(); ++i)
    {
        const auto x = model.surface.points (i, 0);
        moreShapes.row (i) = interpolateOnLine (from, values, slopes, x);
        moreSlopes.row (i) = slopesOnLine (from, values, slopes, x);
    }

    appendColumns (model.shapes, moreShapes);
    appendColumns (model.slopes, moreSlopes);
}

SpillOver describedSpillOver (const WideModel& wide, Eigen::Index designed, double share)
{
    SpillOver spill;
    spill.knownModes = static_cast<int> (wide.known);
    spill.guardedBeyond = static_cast<int> (designed - wide.known);
    spill.playedModes = static_cast<int> (wide.model.modes());
    spill.designedFrequency = wide.model.frequencyHz (designed - 1);
    spill.playedFrequency = wide.highestFrequency();
    spill.share = spill.unguardedShare = share;
    spill.obstacle = wide.obstacle;
    return spill;
}

std::string shareInWords (double share)
{
    return inWords (100 * share) + " %";
}

std::vector<double> guardsToTry (AllocationMethod method)
{
    switch (method)
    {
        case AllocationMethod::exact:
            return { triedGuards.begin(), triedGuards.end() };
        case AllocationMethod::leastVoltage:
            return { triedOfSamples.begin(), triedOfSamples.end() };
        case AllocationMethod::paper:
            break; // It guards no modes.
    }

    return {};
}

/** Guards so many modes beyond the known ones too. None where that cannot be done. */
std::optional<FocusDesign> guardedDesign (const WideModel& wide, FocusDescription description, Playback playback,
                                          DesignExtent extent, Eigen::Index designed)
{
    description.modes.among = static_cast<int> (wide.known);

    try
    {
        auto design = allocateFocus (firstModes (wide.model, designed), description, playback, extent);
        design.description.modes.among.reset();
        design.spillOver = describedSpillOver (wide, designed, spillOverShare (wide, design));
        return design;
    }
    catch (const LimitError&)
    {
        return {}; // The limits leave no room for these guards.
    }
}

/** Whether more guards gain something beyond the known modes, and lose nothing among these: the fewer drives there are,
    the less they leave to keep known modes at rest that are not controlled. */
bool isWorthwhile (const WideModel& wide, const FocusDesign& next, const FocusDesign& best)
{
    return next.spillOver->share < worthwhileShare * best.spillOver->share
           && largestFieldError (wide.model, next) <= largestFieldError (wide.model, best);
}

void sayWhatItCost (FocusDesign& design, const FocusDesign& first)
{
    auto& spill = *design.spillOver;
    spill.unguardedShare = first.spillOver->share;
    spill.unguardedPeak = peakVoltage (first);
    design.choices.push_back (
        "At rest at the focus are " + std::to_string (spill.guardedBeyond) + " modes beyond the "
        + std::to_string (spill.knownModes) + " of the device too: " + shareInWords (spill.unguardedShare)
        + " of the field would be in modes that the design does not know, now " + shareInWords (spill.share)
        + " is. Without that it would need " + inWords (spill.unguardedPeak) + " V, with it "
        + inWords (peakVoltage (design)) + " V.");
}

void warnOfSpillOver (FocusDesign& design)
{
    if (! (design.spillOver->share > allowedSpillOver))
        return;

    const auto& choice = design.description.allocation;
    const auto guards = choice.method != AllocationMethod::paper;
    const std::string room = choice.isNearBound() ? "larger 'times_bound'" : "higher voltage limit";
    design.warnings.push_back (shareInWords (design.spillOver->share) + " of the field is in modes beyond the "
                               + std::to_string (design.spillOver->knownModes) + " of the device. "
                               + (guards ? "Its waveforms have kinks or steps that guards do not remove; a " + room
                                               + " or a longer focus time makes them smoother."
                                         : "This method guards no modes; use the allocation 'exact'."));
}
} // namespace

ModalModel firstModes (const ModalModel& model, Eigen::Index count)
{
    if (count >= model.modes())
        return model;

    requireRealModes (model, "selections of modes");
    auto first = model;
    first.angularFrequencies = model.angularFrequencies.head (count);
    first.dampingRatios = model.dampingRatios.head (count);
    first.shapes = model.shapes.leftCols (count);
    first.participation = model.participation.topRows (count);

    if (model.slopes.size() > 0)
        first.slopes = model.slopes.leftCols (count);

    if (model.frequencyErrors.size() > 0)
        first.frequencyErrors = model.frequencyErrors.head (count);

    return first;
}

WideModel withModesBeyond (const ModalModel& known, const ModalModel& wide)
{
    const auto count = wide.modes() - known.modes();
    const auto isSame = count > 0 && known.actuators() == wide.actuators()
                        && known.surface.grid.has_value() == wide.surface.grid.has_value()
                        && ((wide.angularFrequencies.head (known.modes()) - known.angularFrequencies).array().abs()
                            <= sameFrequency * known.angularFrequencies.array())
                               .all();

    if (! isSame)
        throw InputError ("device '" + known.name + "'", "has no modes beyond these in its second solution");

    WideModel result { known, known.modes(), {} };
    auto& model = result.model;
    appendRows (model.angularFrequencies, wide.angularFrequencies.tail (count));
    appendRows (model.dampingRatios, wide.dampingRatios.tail (count));
    model.participation.conservativeResize (wide.modes(), Eigen::NoChange);
    model.participation.bottomRows (count) = wide.participation.bottomRows (count);
    appendShapes (model, wide, count);

    if (known.frequencyErrors.size() == known.modes() && wide.frequencyErrors.size() == wide.modes())
        appendRows (model.frequencyErrors, wide.frequencyErrors.tail (count));
    else
        model.frequencyErrors.resize (0);

    return result;
}

double spillOverShare (const WideModel& wide, const Eigen::VectorXd& modalVelocities)
{
    const auto& areas = wide.model.surface.areas;
    const auto beyond = wide.model.modes() - wide.known;

    if (beyond == 0)
        return 0;

    const Eigen::VectorXd outside = wide.model.shapes.rightCols (beyond) * modalVelocities.tail (beyond);
    const Eigen::VectorXd inside = wide.model.shapes.leftCols (wide.known) * modalVelocities.head (wide.known);
    const auto whole = areas.dot ((inside + outside).cwiseAbs2());
    return whole > 0 ? std::sqrt (areas.dot (outside.cwiseAbs2()) / whole) : 0;
}

double spillOverShare (const WideModel& wide, const FocusDesign& design)
{
    double largest = 0;

    for (const auto& moment : design.moments)
        largest = std::max (
            largest, spillOverShare (
                         wide, modalVelocities (wide.model, predictStates (wide.model, design.program, moment.time))));

    return largest;
}

double frequencyBeyond (const ModalModel& known, double sampleRate)
{
    constexpr auto playableMultiple = 60.0; // of the sample rate: what the plate model takes
    return std::min (widePlay * known.frequencyHz (known.modes() - 1), playableMultiple * sampleRate);
}

FocusDesign designGuarding (const ModalModel& guarded, Eigen::Index known, FocusDescription description,
                            Playback playback)
{
    description.modes.among = static_cast<int> (known);
    auto design = designFocus (guarded, description, playback, DesignExtent::playable);
    design.description.modes.among.reset();
    return design;
}

FocusDesign designWithin (const WideModel& wide, const FocusDescription& description, Playback playback,
                          DesignExtent extent)
{
    const auto known = firstModes (wide.model, wide.known);
    auto first = allocateFocus (known, description, playback, extent);

    if (wide.known == wide.model.modes() || wide.model.hasComplexModes())
        return finishDesign (std::move (first), known, extent);

    first.spillOver = describedSpillOver (wide, wide.known, spillOverShare (wide, first));
    auto best = first;
    // Samples guard all that is known of, where so many times the device's modes are not.
    const auto mostGuarded = first.program.samples ? wide.model.modes() : std::numeric_limits<Eigen::Index>::max();
    Eigen::Index tried = 0;

    for (const auto multiple : guardsToTry (description.allocation.method))
    {
        const auto designed =
            std::min (static_cast<Eigen::Index> (std::ceil (multiple * static_cast<double> (wide.known))), mostGuarded);

        if (best.spillOver->share <= allowedSpillOver || designed > wide.model.modes() || designed == tried)
            break;

        tried = designed;

        auto next = guardedDesign (wide, description, playback, extent, designed);

        if (next && isWorthwhile (wide, *next, best))
            best = std::move (*next);
    }

    const auto guarded = best.spillOver->guardedBeyond;
    best = finishDesign (std::move (best), firstModes (wide.model, wide.known + guarded), extent);

    if (guarded > 0)
        sayWhatItCost (best, first);

    warnOfSpillOver (best);
    return best;
}

namespace
{
std::vector<Finger> knownFingers (const std::vector<Finger>& fingers)
{
    std::vector<Finger> known;
    std::copy_if (fingers.begin(), fingers.end(), std::back_inserter (known),
                  [] (const auto& finger) { return finger.isKnown; });
    return known;
}

WideDesign designUnderFingers (const WideModel& wide, const FocusDescription& focus, Playback playback,
                               DesignExtent extent)
{
    const auto known = knownFingers (focus.fingers).size();
    auto played = playedUnderFingers (wide, focus.fingers);
    auto design = known == 0 ? designWithin (wide, focus, playback, extent)
                             : designFocus (*played.designed, focus, playback, extent);
    design.choices.push_back ("Fingers on the surface: " + std::to_string (focus.fingers.size())
                              + ", of which the design knows " + std::to_string (known) + ".");
    return { std::move (played), std::move (design) };
}
} // namespace

WideModel loadedByFingers (const WideModel& wide, const std::vector<Finger>& fingers)
{
    if (fingers.empty())
        return wide;

    auto played = loadedModel (wide.model, fingers);
    auto designed = loadedModel (firstModes (wide.model, wide.known), knownFingers (fingers));
    const auto count = played.modes();
    const auto sentence = "Not separable: fingers mix the modes of the device with those beyond. Played are "
                          + std::to_string (count) + " modes, to " + inWords (played.frequencyHz (count - 1)) + " Hz.";
    return { std::move (played), count, sentence, std::move (designed) };
}

WideModel playedUnderFingers (const WideModel& wide, const std::vector<Finger>& fingers)
{
    auto played = loadedByFingers (wide, fingers);

    if (canLiftOff (fingers))
    {
        played.model = wide.model;
        played.known = wide.model.modes();
    }

    return played;
}

WideDesign designWide (WideModel wide, const FocusDescription& focus, Playback playback, const WidenModel& widen,
                       DesignExtent extent)
{
    if (! focus.fingers.empty())
        return designUnderFingers (wide, focus, playback, extent);

    auto design = designWithin (wide, focus, playback, extent);

    if (auto& spill = design.spillOver; spill && spill->guardedBeyond > 0 && wide.obstacle.empty()
                                        && wide.highestFrequency() < widePlay * spill->designedFrequency)
    {
        wide = widen (firstModes (wide.model, wide.known), widePlay * spill->designedFrequency);
        spill->share = spillOverShare (wide, design);
        spill->playedModes = static_cast<int> (wide.model.modes());
        spill->playedFrequency = wide.highestFrequency();
        spill->obstacle = wide.obstacle;
    }

    return { std::move (wide), std::move (design) };
}
} // namespace antinode
