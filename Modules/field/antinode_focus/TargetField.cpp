#include "TargetField.h"

#include "Projection.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace antinode
{
namespace
{
constexpr double sincHalfWidth = 1.895494267033981; // sin (x) / x = 1/2

double sinc (double x)
{
    return std::abs (x) < 1e-8 ? 1.0 : std::sin (x) / x;
}

double bump (double u)
{
    return std::abs (u) < 1 ? std::exp (1 - 1 / (1 - u * u)) : 0.0;
}

/** One end of Tukey's window: 0 at the end, rising as a raised cosine to 1 at the taper's length. */
double tukey (double fromEnd, double taper)
{
    if (taper <= 0 || fromEnd >= taper)
        return 1;

    return 0.5 * (1 - std::cos (std::numbers::pi * std::max (fromEnd, 0.0) / taper));
}

/** The same by the distance from what holds a boundary. Outside it the window stays 0 where it is 0 at the edge. */
double boundaryFactor (const Surface& surface, double x, double y, double share)
{
    const auto& [outline, held] = *surface.boundary;
    const Eigen::Vector2d place (x, y);
    const auto taper =
        0.5 * share * std::min (surface.xMaximum - surface.xMinimum, surface.yMaximum - surface.yMinimum);
    auto distance = taper;

    for (const auto& piece : held)
        distance = std::min (distance, (piece.nearest (place) - place).norm());

    return distance >= taper ? 1.0 : outline.contains (x, y) ? tukey (distance, taper) : 0.0;
}

/** The window at a place: tapered at the edges that cannot move. */
double edgeFactor (const Surface& surface, double x, double y, double share)
{
    if (surface.boundary)
        return boundaryFactor (surface, x, y, share);

    const auto taperX = 0.5 * share * (surface.xMaximum - surface.xMinimum);
    const auto taperY = 0.5 * share * (surface.yMaximum - surface.yMinimum);
    const auto& held = surface.held;
    const auto left = held.left ? tukey (x - surface.xMinimum, taperX) : 1.0;
    const auto right = held.right ? tukey (surface.xMaximum - x, taperX) : 1.0;

    if (surface.kind == SurfaceKind::line)
        return left * right;

    const auto bottom = held.bottom ? tukey (y - surface.yMinimum, taperY) : 1.0;
    const auto top = held.top ? tukey (surface.yMaximum - y, taperY) : 1.0;
    return left * right * bottom * top;
}

double widthInY (const Target& target)
{
    return target.widthY.value_or (target.width);
}

/** From the target's centre, m. */
Eigen::Vector2d offsetFrom (const Surface& surface, double x, double y, const Target& target)
{
    return { x - target.x, surface.kind == SurfaceKind::line ? 0.0 : y - target.y };
}

double profileAt (const Surface& surface, double x, double y, const Target& target)
{
    const auto offset = offsetFrom (surface, x, y, target);

    if (target.profile == TargetProfile::radial)
        return targetProfile (target.shape, offset.norm(), target.width);

    return targetProfile (target.shape, offset.x(), target.width)
           * targetProfile (target.shape, offset.y(), widthInY (target));
}

/** The distance from the target's centre in widths, each axis in its own: the spot ends at 1. */
double widthsAway (const Surface& surface, Eigen::Index point, const Target& target)
{
    const auto offset = offsetFrom (surface, surface.points (point, 0), surface.points (point, 1), target);
    return std::hypot (offset.x() / target.width, offset.y() / widthInY (target));
}
} // namespace

double targetProfile (TargetShape shape, double distance, double width)
{
    const auto relative = 2 * distance / width; // 1 at half maximum

    switch (shape)
    {
        case TargetShape::sinc:
            return sinc (sincHalfWidth * relative);
        case TargetShape::bump:
            // Half maximum where 1/(1 - u^2) = 1 + ln 2.
            return bump (relative * std::sqrt (std::numbers::ln2 / (1 + std::numbers::ln2)));
        case TargetShape::gaussian:
            return std::exp (-std::numbers::ln2 * relative * relative);
    }

    return 0;
}

double targetVelocity (const Surface& surface, const std::vector<Target>& targets, std::optional<double> edgeWindow,
                       double x, double y)
{
    double velocity = 0;

    for (const auto& target : targets)
        velocity += target.phase * target.peakVelocity * profileAt (surface, x, y, target);

    return edgeWindow ? velocity * edgeFactor (surface, x, y, *edgeWindow) : velocity;
}

Eigen::VectorXd targetField (const Surface& surface, const std::vector<Target>& targets,
                             std::optional<double> edgeWindow)
{
    Eigen::VectorXd field (surface.points.rows());

    for (Eigen::Index i = 0; i < field.size(); ++i)
        field[i] = targetVelocity (surface, targets, edgeWindow, surface.points (i, 0), surface.points (i, 1));

    return field;
}

double fieldContrast (const Surface& surface, const Eigen::VectorXd& field, const std::vector<Target>& targets,
                      double peak)
{
    double square = 0, area = 0;

    for (Eigen::Index i = 0; i < field.size(); ++i)
    {
        const auto outside = std::all_of (targets.begin(), targets.end(),
                                          [&] (const Target& target) { return widthsAway (surface, i, target) > 1; });

        if (outside)
        {
            square += surface.areas[i] * field[i] * field[i];
            area += surface.areas[i];
        }
    }

    return square > 0 ? std::abs (peak) / std::sqrt (square / area) : 0.0;
}

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
    if (times > 1 && method != AllocationMethod::exact)
        throw InputError ("focus: targets",
                          "have " + std::to_string (times)
                              + " different times; allowed: one time, or the allocation method 'exact'");
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
