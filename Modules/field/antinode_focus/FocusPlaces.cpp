#include "FocusPlaces.h"

#include "DesignFocus.h"
#include "Projection.h"
#include "TargetField.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_model/Surface.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
/** The position of one of several along a side, from margin to margin. */
double along (double minimum, double maximum, double margin, int index, int count)
{
    const auto kept = std::min (margin, (maximum - minimum) / 3);
    const auto share = count > 1 ? static_cast<double> (index) / (count - 1) : 0.5;
    return minimum + kept + share * (maximum - minimum - 2 * kept);
}
} // namespace

std::vector<std::pair<double, double>> bankPlaces (const Surface& surface, int count, double margin)
{
    if (count < 1)
        return {};

    const auto width = surface.xMaximum - surface.xMinimum, height = surface.yMaximum - surface.yMinimum;
    const auto isLine = surface.kind == SurfaceKind::line || ! (height > 0);
    const auto columns =
        isLine ? count : std::clamp (static_cast<int> (std::lround (std::sqrt (count * width / height))), 1, count);
    const auto rows = (count + columns - 1) / columns;
    std::vector<std::pair<double, double>> places;
    places.reserve (static_cast<std::size_t> (count));

    for (int i = 0; i < count; ++i)
    {
        const Eigen::Vector2d place (along (surface.xMinimum, surface.xMaximum, margin, i % columns, columns),
                                     isLine ? 0.0
                                            : along (surface.yMinimum, surface.yMaximum, margin, i / columns, rows));
        const Eigen::Vector2d on = surface.boundary ? nearestOn (surface, place.x(), place.y()) : place;
        places.emplace_back (on.x(), on.y());
    }

    return places;
}

FocusDescription movedTo (FocusDescription focus, double x, double y)
{
    const auto shiftX = x - focus.targets.front().x, shiftY = y - focus.targets.front().y;

    for (auto& target : focus.targets)
    {
        target.x += shiftX;
        target.y += shiftY;
    }

    return focus;
}

namespace
{
constexpr int cellsOfLine = 400, cellsOfPlate = 2000, refinements = 8;
constexpr double centrePull = 0.02;                          // m of distance to an edge for a m from the centre
constexpr double usualWidth = 0.025, widthStep = 1.25;       // m
constexpr double usualVelocity = 0.02, slowest = 1e-4;       // m/s
constexpr double usualFocusTime = 0.025, latestFocus = 0.25; // s
constexpr double periodsToFocus = 3;                         // of the lowest mode
constexpr double goodCapture = 0.95;                         // a little above what is warned of
constexpr double shareOfLimit = 0.8, shareOfNyquist = 0.8;

double distanceToRectangle (double x, double y, const Ceramic& ceramic, bool isLine)
{
    const auto alongX = std::max ({ ceramic.xMinimum - x, x - ceramic.xMaximum, 0.0 });
    return isLine ? alongX : std::hypot (alongX, std::max ({ ceramic.yMinimum - y, y - ceramic.yMaximum, 0.0 }));
}

double distanceToCeramic (double x, double y, const Ceramic& ceramic, bool isLine)
{
    if (isLine || ceramic.outline.paths.empty())
        return distanceToRectangle (x, y, ceramic, isLine);

    return ceramic.outline.contains (x, y) ? 0.0 : distanceToBoundary (ceramic.outline, x, y);
}

/** How far a place is from all that is in the way, less where it is far from the centre. m */
double freedom (const ModalModel& model, double x, double y)
{
    const auto& surface = model.surface;
    const auto isLine = surface.kind == SurfaceKind::line;

    if (! liesOn (surface, x, y))
        return -1;

    auto distance = distanceToEdge (surface, x, y);

    for (const auto& ceramic : model.ceramics)
        distance = std::min (distance, distanceToCeramic (x, y, ceramic, isLine));

    const auto fromCentreX = x - (surface.xMinimum + surface.xMaximum) / 2,
               fromCentreY = isLine ? 0.0 : y - (surface.yMinimum + surface.yMaximum) / 2;
    return distance - centrePull * std::hypot (fromCentreX, fromCentreY);
}

/** In steps that halve. */
Eigen::Vector2d refine (const ModalModel& model, Eigen::Vector2d best, double step)
{
    for (int i = 0; i < refinements; ++i, step /= 2)
        for (const auto& [alongX, alongY] : { std::pair (1, 0), { -1, 0 }, { 0, 1 }, { 0, -1 } })
            if (const Eigen::Vector2d tried = best + step * Eigen::Vector2d (alongX, alongY);
                freedom (model, tried.x(), tried.y()) > freedom (model, best.x(), best.y()))
                best = tried;

    return best;
}

double rounded (double value, double unit)
{
    return std::round (value / unit) * unit;
}

/** To 1, 2 or 5 times a power of ten, downwards. */
double roundedDown (double value)
{
    const auto decade = std::pow (10, std::floor (std::log10 (value)));
    const auto digits = value / decade;
    return decade * (digits >= 5 ? 5 : digits >= 2 ? 2 : 1);
}

double captureOf (const ModalModel& model, const FocusDescription& focus)
{
    try
    {
        const auto field = targetField (model.surface, focus.targets, focus.edgeWindow);
        return selectModes (model, projectField (model, field), focus.modes).captured;
    }
    catch (const InputError&)
    {
        return 0;
    }
}

/** The narrowest that is represented well, else the one that is represented best. */
void chooseWidth (const ModalModel& model, FocusDescription& focus)
{
    const auto& surface = model.surface;
    const auto lengthX = surface.xMaximum - surface.xMinimum;
    const auto shorter =
        surface.kind == SurfaceKind::line ? lengthX : std::min (lengthX, surface.yMaximum - surface.yMinimum);
    auto& target = focus.targets.front();
    auto best = target;
    double most = -1;

    const auto narrowest = std::min (usualWidth, shorter / 4);
    const auto steps = static_cast<int> (std::log (shorter / 2 / narrowest) / std::log (widthStep) + 1e-9);

    for (const auto shape : { TargetShape::bump, TargetShape::sinc })
        for (int step = 0; step <= steps; ++step)
        {
            const auto width = narrowest * std::pow (widthStep, step);
            checkWatch();
            target.shape = shape;
            target.width = rounded (width, width > usualWidth ? 1e-3 : 1e-4);
            const auto captured = captureOf (model, focus);

            if (captured > most)
            {
                most = captured;
                best = target;
            }

            if (captured >= goodCapture)
                return;
        }

    target = best;
}

/** What the limits allow; nothing is known where there is no design for another reason. */
void chooseVelocity (const ModalModel& model, Playback playback, FocusDescription& focus)
{
    auto& velocity = focus.targets.front().peakVelocity;

    try
    {
        designFocus (model, focus, playback, DesignExtent::playable);
    }
    catch (const LimitError& failure)
    {
        velocity = std::max (slowest, roundedDown (shareOfLimit * failure.reachableVelocity));
    }
    catch (const InputError&)
    {
    }
}
} // namespace

double distanceToEdge (const Surface& surface, double x, double y)
{
    const auto alongX = std::min (x - surface.xMinimum, surface.xMaximum - x);

    if (surface.kind == SurfaceKind::line)
        return alongX;

    if (surface.boundary)
        return distanceToBoundary (surface.boundary->outline, x, y);

    return std::min ({ alongX, y - surface.yMinimum, surface.yMaximum - y });
}

Eigen::Vector2d middleOfFreeArea (const ModalModel& model)
{
    const auto& surface = model.surface;
    const auto isLine = surface.kind == SurfaceKind::line;
    const auto cells = squareCells (surface, isLine ? cellsOfLine : cellsOfPlate);
    Eigen::Vector2d best = cells.centres.row (0);

    for (const Eigen::Vector2d place : cells.centres.rowwise())
        if (freedom (model, place.x(), place.y()) > freedom (model, best.x(), best.y()))
            best = place;

    return refine (model, best, (surface.xMaximum - surface.xMinimum) / static_cast<double> (cells.columns) / 2);
}

FocusDescription suitableFocus (const ModalModel& model, Playback playback)
{
    constexpr double placeUnit = 1e-4; // m
    const auto place = middleOfFreeArea (model);
    FocusDescription focus;
    focus.name = "suited";
    Target target;
    target.x = rounded (place.x(), placeUnit);
    target.y = model.surface.kind == SurfaceKind::line ? 0.0 : rounded (place.y(), placeUnit);
    target.peakVelocity = usualVelocity;
    focus.targets = { target };
    focus.probes = { { target.x, target.y } };
    focus.focusTime =
        std::clamp (std::ceil (1000 * periodsToFocus / model.frequencyHz (0)) / 1000, usualFocusTime, latestFocus);

    // Modes that the rate cannot play are left to a device that is played at another one.
    if (playback.sampleRate > 0 && model.frequencyHz (model.modes() - 1) > shareOfNyquist * playback.sampleRate / 2)
        focus.modes.maximumFrequency = rounded (shareOfNyquist * playback.sampleRate / 2, 1);

    chooseWidth (model, focus);
    chooseVelocity (model, playback, focus);
    return focus;
}
} // namespace antinode
