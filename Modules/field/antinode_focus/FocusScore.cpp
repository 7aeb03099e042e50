#include "FocusScore.h"

#include "FocusDesign.h"
#include "PeakSearch.h"
#include "Prediction.h"
#include "TargetField.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double lineDensity = 4, plateDensity = 2; // more than 12 places per wave of the highest mode
constexpr double promising = 0.9;                   // so near, a peak between two places may be the largest
constexpr std::size_t maximumFieldStarts = 32;

/** A field as the only mode of a model: its values, and its slopes on a line, interpolate as those of modes do. */
ModalModel fieldAsMode (const ModalModel& model, const Eigen::VectorXd& modalVelocities)
{
    ModalModel field;
    field.name = model.name;
    field.surface = model.surface;
    field.angularFrequencies = Eigen::VectorXd::Ones (1);
    field.shapes = model.shapes * modalVelocities;

    if (model.slopes.size() > 0)
        field.slopes = model.slopes * modalVelocities;

    return field;
}

/** How far a surface goes on from a place, along x or y, in either direction. */
std::pair<double, double> roomAround (const Surface& surface, const FieldPeak& place, bool isAlongY)
{
    const auto at = isAlongY ? place.y : place.x;
    auto below = isAlongY ? surface.yMinimum : surface.xMinimum, above = isAlongY ? surface.yMaximum : surface.xMaximum;

    if (surface.boundary)
        for (const auto crossed : crossings (surface.boundary->outline, isAlongY ? PlaneAxis::x : PlaneAxis::y,
                                             isAlongY ? place.x : place.y))
        {
            if (crossed <= at)
                below = crossed;

            above = crossed > at ? std::min (above, crossed) : above;
        }

    return { at - below, above - at };
}

double densityOn (const Surface& surface)
{
    return surface.kind == SurfaceKind::line ? lineDensity : plateDensity;
}

FieldPeak largestPeak (const Surface& surface, const VelocityFunction& velocity, const SearchPlaces& places,
                       const std::vector<FocalSpot>& outside)
{
    return climbToPeak (velocity, chooseStarts (places.starts, places.steps, promising, maximumFieldStarts),
                        places.steps, { surface, outside });
}
} // namespace

std::vector<FocalSpot> focalSpots (const std::vector<Target>& targets)
{
    std::vector<FocalSpot> spots;
    spots.reserve (targets.size());

    for (const auto& target : targets)
        spots.push_back ({ target.x, target.y, target.width, target.widthY.value_or (target.width) });

    return spots;
}

FieldPeak largestVelocity (const ModalModel& model, const Eigen::VectorXd& modalVelocities,
                           const std::vector<FocalSpot>& outside)
{
    const auto field = fieldAsMode (model, modalVelocities);
    auto places = searchPlaces (field, densityOn (field.surface), outside);

    for (std::size_t i = 0; i < places.starts.size(); ++i)
        places.starts[i].at.velocity = places.shapes (static_cast<Eigen::Index> (i), 0);

    return largestPeak (
        field.surface, [&] (double x, double y, double) { return shapesAt (field, x, y)[0]; }, places, outside);
}

FieldPeak largestWanted (const Surface& surface, const std::vector<Target>& targets, std::optional<double> edgeWindow,
                         const std::vector<FocalSpot>& outside)
{
    const auto velocity = [&] (double x, double y, double)
    { return targetVelocity (surface, targets, edgeWindow, x, y); };
    ModalModel still;
    still.surface = surface;
    still.shapes.resize (surface.points.rows(), 0);
    still.slopes.resize (surface.points.rows(), 0);
    auto places = searchPlaces (still, densityOn (surface), outside);

    if (outside.empty())
        for (const auto& target : targets)
            places.starts.push_back ({ { target.x, target.y }, -1, 0 });

    for (auto& start : places.starts)
        start.at.velocity = velocity (start.at.x, start.at.y, 0);

    return largestPeak (surface, velocity, places, outside);
}

FieldPeak largestTruncated (const ModalModel& model, const FocusDesign& design, const FocusMoment& moment)
{
    Eigen::VectorXd velocities = Eigen::VectorXd::Zero (model.coordinates());
    velocities (design.controlledModes) = moment.wanted;
    return largestVelocity (model, velocities);
}

FieldPeak peakOfTarget (const ModalModel& model, const Eigen::VectorXd& modalVelocities, const Target& target)
{
    constexpr double stepsPerWidth = 8;
    const auto field = fieldAsMode (model, modalVelocities);
    const auto spot = focalSpots ({ target }).front();
    const PeakSteps steps { spot.radiusX / stepsPerWidth, spot.radiusY / stepsPerWidth, 0 };
    const PeakStart start { { target.x, target.y, 0, static_cast<double> (target.phase) }, -1, 0 };
    return climbToPeak ([&] (double x, double y, double) { return shapesAt (field, x, y)[0]; }, { start }, steps,
                        { field.surface });
}

std::optional<double> widthAtHalf (const ModalModel& model, const Eigen::VectorXd& modalVelocities,
                                   const FieldPeak& peak, bool isAlongY)
{
    constexpr int steps = 400, halvings = 40;
    const auto field = fieldAsMode (model, modalVelocities);
    const auto& surface = field.surface;
    const auto extent = isAlongY ? surface.yMaximum - surface.yMinimum : surface.xMaximum - surface.xMinimum;
    const auto share = [&] (double distance)
    {
        const auto x = isAlongY ? peak.x : peak.x + distance, y = isAlongY ? peak.y + distance : peak.y;
        const auto on = nearestOn (surface, x, y); // beyond it by rounding only
        return shapesAt (field, on.x(), on.y())[0] / peak.velocity;
    };
    const auto room = roomAround (surface, peak, isAlongY);
    const auto halfWidth = [&] (double sign, double most) -> std::optional<double>
    {
        double inside = 0, beyond = 0;

        while (beyond < most && share (sign * beyond) >= 0.5)
        {
            inside = beyond;
            beyond = std::min (most, beyond + extent / steps);
        }

        if (share (sign * beyond) >= 0.5)
            return {};

        for (int i = 0; i < halvings; ++i)
            (share (sign * 0.5 * (inside + beyond)) >= 0.5 ? inside : beyond) = 0.5 * (inside + beyond);

        return inside;
    };
    const auto below = halfWidth (-1, room.first), above = halfWidth (1, room.second);

    if (! below || ! above)
        return {};

    return *below + *above;
}

FieldScore scoreField (const Surface& surface, const Eigen::VectorXd& reached, const Eigen::VectorXd& wanted)
{
    const Eigen::VectorXd share = surface.areas / surface.areas.sum();
    const Eigen::VectorXd r = (reached.array() - share.dot (reached)).matrix();
    const Eigen::VectorXd w = (wanted.array() - share.dot (wanted)).matrix();
    const auto inner = [&] (const Eigen::VectorXd& a, const Eigen::VectorXd& b)
    { return share.dot (a.cwiseProduct (b)); };
    const auto deviations = std::sqrt (inner (r, r) * inner (w, w));
    const Eigen::VectorXd difference = reached - wanted;

    FieldScore score;
    score.vScore = deviations > 0 ? inner (r, w) / deviations : 0.0;
    score.fieldError = std::sqrt (inner (difference, difference) / inner (wanted, wanted));
    return score;
}

FocusScore scoreFocus (const ModalModel& model, const Eigen::VectorXd& modalVelocities, const Eigen::VectorXd& wanted,
                       const FieldPeak& wantedPeak)
{
    return { scoreField (model.surface, model.shapes * modalVelocities, wanted),
             shapesAt (model, wantedPeak.x, wantedPeak.y).dot (modalVelocities) / wantedPeak.velocity };
}

double largestFieldError (const ModalModel& model, const FocusDesign& design)
{
    double largest = 0;

    for (const auto& moment : design.moments)
    {
        const auto velocities = modalVelocities (model, predictStates (model, design.program, moment.time));
        const auto score = scoreField (model.surface, model.shapes * velocities, moment.truncatedField);
        largest = std::max (largest, score.fieldError);
    }

    return largest;
}
} // namespace antinode
