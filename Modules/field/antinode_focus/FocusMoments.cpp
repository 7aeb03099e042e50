#include "FocusMoments.h"

#include "Projection.h"
#include "TargetField.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace antinode
{
namespace
{
double targetTime (const Target& target, const FocusDescription& description)
{
    return target.time.value_or (description.focusTime);
}

double onSample (double time, double first, Playback playback)
{
    return playback.sampleRate > 0 ? first + std::round ((time - first) * playback.sampleRate) / playback.sampleRate
                                   : time;
}

void checkMethod (AllocationMethod method, std::size_t times)
{
    if (times > 1 && ! methodTraits (method).takesTrains)
        throw InputError ("focus: targets", "have " + std::to_string (times)
                                                + " different times; allowed: one time, or the allocation method "
                                                + methodsThat (&AllocationTraits::takesTrains, "or"));
}

void checkRobustness (const AllocationChoice& choice, std::size_t times)
{
    if (times > 1 && choice.robust)
        throw InputError ("focus: robustness", "is requested for targets with " + std::to_string (times)
                                                   + " different times; allowed: one time");
}

/** A target that has, of each mode, the energy of all moments. */
ProjectedTarget jointTarget (const std::vector<FocusMoment>& moments)
{
    auto joint = moments.front().target;
    Eigen::VectorXd energies = Eigen::VectorXd::Zero (joint.modalVelocities.size());

    for (const auto& moment : moments)
        energies += moment.target.modalVelocities.cwiseAbs2();

    joint.modalVelocities = energies.cwiseSqrt();
    return joint;
}
/** Where a target has no velocity on any point: what to do. */
std::string remedyForNothing (const Surface& surface, const Target& target)
{
    Eigen::Index nearest = 0;
    const Eigen::RowVector2d place (target.x, target.y);
    const Eigen::MatrixX2d points = surface.points (pointsOn (surface), Eigen::all);
    const auto distance = (points.rowwise() - place).rowwise().norm().minCoeff (&nearest);

    if (distance < 0.5 * target.width)
        return "widen a target or narrow the edge window";

    return "the nearest of its " + std::to_string (points.rows()) + " points lies " + inWords (distance * 1000)
           + " mm from the target, at " + inWords (points (nearest, 0) * 1000) + ", "
           + inWords (points (nearest, 1) * 1000)
           + " mm: give a drawn device what these points say (antinode retune, or antinode identify with --against and "
             "--transfer), measure more points, or widen the target";
}
} // namespace

double earliestFocusTime (const FocusDescription& description)
{
    auto time = targetTime (description.targets.front(), description);

    for (const auto& target : description.targets)
        time = std::min (time, targetTime (target, description));

    return time;
}

double latestFocusTime (const FocusDescription& description)
{
    auto time = targetTime (description.targets.front(), description);

    for (const auto& target : description.targets)
        time = std::max (time, targetTime (target, description));

    return time;
}

std::vector<double> momentTimes (const std::vector<FocusMoment>& moments)
{
    std::vector<double> times (moments.size());
    std::transform (moments.begin(), moments.end(), times.begin(),
                    [] (const FocusMoment& moment) { return moment.time; });

    return times;
}

std::vector<FocusMoment> focusMoments (const ModalModel& model, const FocusDescription& description, Playback playback)
{
    std::map<double, std::vector<Target>> byTime;

    for (const auto& target : description.targets)
        byTime[onSample (targetTime (target, description), earliestFocusTime (description), playback)].push_back (
            target);

    checkMethod (description.allocation.method, byTime.size());
    checkRobustness (description.allocation, byTime.size());
    std::vector<FocusMoment> moments;

    for (const auto& [time, targets] : byTime)
    {
        FocusMoment moment { time, targets, {}, {}, {}, 0 };
        moment.target = projectField (model, targetField (model.surface, targets, description.edgeWindow));

        if (! (moment.target.energy > 0))
            throw InputError ("focus: targets", "give no velocity anywhere on '" + model.name + "' at "
                                                    + inWords (time * 1000) + " ms; "
                                                    + remedyForNothing (model.surface, targets.front()));

        moments.push_back (std::move (moment));
    }

    return moments;
}

std::vector<int> controlModes (const ModalModel& model, const ModeChoice& choice, std::vector<FocusMoment>& moments)
{
    std::set<int> chosen;

    if (choice.count)
    {
        const auto selection = selectModes (model, jointTarget (moments), choice);
        chosen.insert (selection.modes.begin(), selection.modes.end());
    }
    else
        for (const auto& moment : moments)
        {
            const auto selection = selectModes (model, moment.target, choice);
            chosen.insert (selection.modes.begin(), selection.modes.end());
        }

    std::vector<int> modes (chosen.begin(), chosen.end());

    for (auto& moment : moments)
    {
        auto selection = restrictToModes (model, moment.target, modes);
        moment.wanted = std::move (selection.wanted);
        moment.truncatedField = std::move (selection.truncated);
        moment.captured = selection.captured;
    }

    return modes;
}
} // namespace antinode
