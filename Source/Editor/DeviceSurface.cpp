#include "DeviceSurface.h"

#include "EditorLook.h"

#include <Eigen/Geometry>
#include <Processor/ParameterSet.h>
#include <antinode_drafts/DeviceEdits.h>
#include <antinode_reports/Lettering.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr float nearEdge = 7, nearPoint = 10, nearCorner = 8, nearSpot = 11, guideReach = 5; // pixels
constexpr float halfStrip = 11; // pixels, of a ceramic on a line
constexpr double gridStep = 1;  // mm
constexpr double angleStep = 5; // degrees
constexpr double inMetres = 1e-3;

template <typename ToPixels>
juce::Path pathAlong (const std::vector<PathPiece>& pieces, const ToPixels& toPixels)
{
    constexpr int steps = 12; // of an arc
    juce::Path path;
    Eigen::Vector2d last = Eigen::Vector2d::Constant (-1e9);

    for (const auto& piece : pieces)
    {
        if (last != piece.start)
            path.startNewSubPath (toPixels (piece.start / inMetres));

        const auto count = piece.isStraight ? 1 : steps;

        for (int i = 1; i <= count; ++i)
            path.lineTo (toPixels (piece.at (piece.from + (piece.to - piece.from) * i / count) / inMetres));

        last = piece.end;
    }

    return path;
}

template <typename ToPixels>
juce::Path pathAround (const Outline& outline, const ToPixels& toPixels)
{
    juce::Path path;
    path.setUsingNonZeroWinding (false);

    for (const auto& closed : outline.paths)
    {
        auto each = pathAlong (closed, toPixels);
        each.closeSubPath();
        path.addPath (each);
    }

    return path;
}

/** The nearest of some values within a reach. */
std::optional<double> nearest (double value, const std::vector<double>& values, double reach)
{
    std::optional<double> best;

    for (const auto each : values)
        if (std::abs (each - value) <= reach && (! best || std::abs (each - value) < std::abs (*best - value)))
            best = each;

    return best;
}

double toStep (double value, double step)
{
    return std::round (value / step) * step;
}
} // namespace

DeviceSurface::DeviceSurface (AntinodeProcessor& processor, DeviceDraft& draftToShow)
    : SurfaceView (
        "The device that is drawn, with a mode of it. Arrow keys move the selected ceramics by 1 mm, with Shift by "
        "0.1 mm; Delete removes them.",
        "Drag ceramics, feet, masses and the spot; the square at a ceramic sizes it, the circle turns it. Alt: without "
        "snapping. Shift: more than one.\nA click on an edge says how it is held. A right click adds and removes.",
        false),
      draft (draftToShow)
{
    const auto& parameters = processor.parameters();
    spotPlace = { parameters.find ("x"), parameters.find ("y") };
    setWantsKeyboardFocus (true);
}

void DeviceSurface::show (std::shared_ptr<const DraftPicture> newPicture)
{
    picture = std::move (newPicture);
    setPicture (picture);
}

void DeviceSurface::refresh()
{
    const auto spotNow = parameterValue (*spotPlace.x) * 1000 + parameterValue (*spotPlace.y);

    if (std::exchange (paintedChange, draft.changes()) != draft.changes()
        || std::exchange (shownSpot, static_cast<float> (spotNow)) != static_cast<float> (spotNow))
        repaint();
}

juce::Point<float> DeviceSurface::pixelsOf (const Eigen::Vector2d& millimetres) const
{
    return plot().at (millimetres.x(), isLine() ? 0 : millimetres.y());
}

Eigen::Vector2d DeviceSurface::millimetresAt (juce::Point<float> at) const
{
    const auto& frame = plot();
    const auto along = [] (const AxisRange& range, double share)
    { return range.minimum + share * (range.maximum - range.minimum); };
    const auto x = along (frame.x.range, static_cast<double> ((at.x - frame.plot.getX()) / frame.plot.getWidth()));
    const auto y =
        along (frame.y.range, static_cast<double> ((frame.plot.getBottom() - at.y) / frame.plot.getHeight()));
    return { x, isLine() ? 0 : y };
}

juce::Path DeviceSurface::pathOfCeramic (const DrawnCeramic& ceramic) const
{
    if (! isLine())
        return pathAround (outlineOf (ceramic), [this] (const Eigen::Vector2d& place) { return pixelsOf (place); });

    juce::Path path;
    const auto left = plot().xAt (ceramic.centre.x() - ceramic.size.x() / 2),
               right = plot().xAt (ceramic.centre.x() + ceramic.size.x() / 2);
    path.addRectangle (left, plot().yAt (0) - halfStrip, right - left, 2 * halfStrip);
    return path;
}

const DeviceSurface::Drawn& DeviceSurface::drawn()
{
    if (cachedChange == draft.changes() && cachedPlot == plot().plot)
        return cached;

    cachedChange = draft.changes();
    cachedPlot = plot().plot;
    cached = {};

    if (! draft.isDrawn())
        return cached;

    const auto& device = draft.document();
    const auto toPixels = [this] (const Eigen::Vector2d& place) { return pixelsOf (place); };

    for (const auto& ceramic : ceramicsOf (device))
        cached.ceramics.push_back (pathOfCeramic (ceramic));

    if (isLine())
        return cached;

    cached.body = pathAround (outlineOf (device), toPixels);

    for (const auto& edge : edgesOf (device))
    {
        cached.edges.push_back (pathAlong (edge.pieces, toPixels));
        cached.edgeNames.push_back (edge.name);
    }

    for (const auto& point : pointsOf (device))
        cached.points.push_back (pixelsOf (point.place));

    return cached;
}

juce::Point<float> DeviceSurface::middleOf (std::size_t ceramic)
{
    return drawn().ceramics.at (ceramic).getBounds().getCentre();
}

std::optional<std::size_t> DeviceSurface::ceramicAt (juce::Point<float> at)
{
    const auto& all = drawn().ceramics;

    for (auto i = all.size(); i-- > 0;)
        if (all[i].contains (at))
            return i;

    return std::nullopt;
}

std::optional<std::size_t> DeviceSurface::pointAt (juce::Point<float> at)
{
    const auto& all = drawn().points;

    for (auto i = all.size(); i-- > 0;)
        if (all[i].getDistanceFrom (at) < nearPoint)
            return i;

    return std::nullopt;
}

std::optional<std::size_t> DeviceSurface::edgeAt (juce::Point<float> at)
{
    const auto& all = drawn().edges;
    std::optional<std::size_t> best;
    auto least = nearEdge;

    for (std::size_t i = 0; i < all.size(); ++i)
    {
        juce::Point<float> on;
        all[i].getNearestPoint (at, on);

        if (on.getDistanceFrom (at) < least)
        {
            least = on.getDistanceFrom (at);
            best = i;
        }
    }

    return best;
}

/** Where the only selected ceramic is sized, or turned. */
std::optional<juce::Point<float>> DeviceSurface::cornerOf (Handle handle)
{
    if (draft.ceramics.size() != 1 || *draft.ceramics.begin() >= drawn().ceramics.size())
        return std::nullopt;

    const auto ceramic = ceramicsOf (draft.document())[*draft.ceramics.begin()];

    if (handle == Handle::turn && (isLine() || ceramic.shape != CeramicShape::rectangle))
        return std::nullopt;

    if (isLine())
        return plot().at (ceramic.centre.x() + ceramic.size.x() / 2, 0);

    const auto isRound = ceramic.shape != CeramicShape::rectangle;
    const Eigen::Vector2d half = ceramic.size / 2;
    const Eigen::Vector2d offset = handle == Handle::turn ? Eigen::Vector2d (0, half.y())
                                   : isRound              ? Eigen::Vector2d (half.x(), 0)
                                                          : Eigen::Vector2d (half.x(), -half.y());
    const auto turned = Eigen::Rotation2Dd (ceramic.angle * juce::MathConstants<double>::pi / 180) * offset;
    auto at = pixelsOf (ceramic.centre + turned);

    if (handle == Handle::turn)
    {
        constexpr float beyond = 16; // pixels
        const auto middle = pixelsOf (ceramic.centre);
        const auto away = at - middle;
        at += away * (beyond / std::max (1.0f, away.getDistanceFromOrigin()));
    }

    return at;
}

DeviceSurface::Handle DeviceSurface::handleAt (juce::Point<float> at)
{
    if (! isShown() || ! plot().plot.expanded (nearPoint).contains (at))
        return Handle::none;

    for (const auto handle : { Handle::size, Handle::turn })
        if (const auto corner = cornerOf (handle); corner && corner->getDistanceFrom (at) < nearCorner)
            return handle;

    if (spot().getDistanceFrom (at) < nearSpot)
        return Handle::spot;

    return pointAt (at) ? Handle::point : ceramicAt (at) ? Handle::ceramic : Handle::none;
}

void DeviceSurface::mouseMove (const juce::MouseEvent& event)
{
    const auto handle = handleAt (event.position);
    const auto isEdge = handle == Handle::none && isShown() && edgeAt (event.position);
    setMouseCursor (handle == Handle::size             ? juce::MouseCursor::BottomRightCornerResizeCursor
                    : handle != Handle::none || isEdge ? juce::MouseCursor::PointingHandCursor
                                                       : juce::MouseCursor::NormalCursor);
}

void DeviceSurface::selectAt (juce::Point<float> at, bool isMore)
{
    const auto ceramic = ceramicAt (at);
    const auto handle = handleAt (at);
    draft.point.reset();
    draft.edge.clear();

    if (handle == Handle::point)
    {
        draft.ceramics.clear();
        draft.point = pointAt (at);
    }
    else if (handle == Handle::ceramic)
    {
        if (! isMore && draft.ceramics.count (*ceramic) == 0)
            draft.ceramics.clear();

        if (isMore && draft.ceramics.count (*ceramic) > 0 && draft.ceramics.size() > 1)
            draft.ceramics.erase (*ceramic);
        else
            draft.ceramics.insert (*ceramic);
    }
    else if (handle == Handle::none)
    {
        draft.ceramics.clear();

        if (const auto edge = edgeAt (at))
            draft.edge = drawn().edgeNames[*edge];
    }

    repaint();
}

void DeviceSurface::mouseDown (const juce::MouseEvent& event)
{
    if (! isShown() || ! draft.isDrawn())
        return;

    selectAt (event.position, event.mods.isShiftDown());
    const auto showMenu = [this] (juce::PopupMenu menu)
    { menu.showMenuAsync (juce::PopupMenu::Options().withMousePosition().withDeletionCheck (*this)); };

    if (event.mods.isPopupMenu())
        return showMenu (menuAt (event.position));

    held = handleAt (event.position);

    if (held == Handle::none)
    {
        if (! draft.edge.empty())
            showMenu (edgeMenu());

        return;
    }

    if (held == Handle::spot)
        return grab (spotPlace, event.position - spot());

    heldDocument = draft.document();
    heldAt = millimetresAt (event.position);
    heldCeramic = ceramicAt (event.position).value_or (draft.ceramics.empty() ? 0 : *draft.ceramics.begin());
}

/** To the grid, or to the middle of the device and of other ceramics. */
Eigen::Vector2d DeviceSurface::snapped (const Eigen::Vector2d& place, bool isFree)
{
    guides = {};

    if (isFree)
        return place;

    const auto extent = extentOf (outlineOf (heldDocument));
    const Eigen::Vector2d middle = (extent.least + extent.largest) / 2 / inMetres;
    const Eigen::Vector2d reach = (millimetresAt ({ guideReach, 0 }) - millimetresAt ({ 0, guideReach })).cwiseAbs();
    std::vector<double> xs { middle.x() }, ys { middle.y() };
    const auto all = ceramicsOf (heldDocument);

    for (std::size_t i = 0; i < all.size(); ++i)
        if (draft.ceramics.count (i) == 0 || held == Handle::point)
        {
            xs.push_back (all[i].centre.x());
            ys.push_back (all[i].centre.y());
        }

    guides = { nearest (place.x(), xs, reach.x()), isLine() ? std::nullopt : nearest (place.y(), ys, reach.y()) };
    return { guides.x.value_or (toStep (place.x(), gridStep)), guides.y.value_or (toStep (place.y(), gridStep)) };
}

void DeviceSurface::dragCeramics (const Eigen::Vector2d& by, bool isFree)
{
    const Eigen::Vector2d from = ceramicsOf (heldDocument)[heldCeramic].centre;
    draft.drag (withShifted (heldDocument, draft.ceramics, snapped (from + by, isFree) - from));
}

void DeviceSurface::dragCorner (juce::Point<float> at, bool isFree)
{
    const auto index = *draft.ceramics.begin();
    auto ceramic = ceramicsOf (heldDocument)[index];
    const Eigen::Vector2d offset = millimetresAt (at) - ceramic.centre;
    const auto radians = juce::MathConstants<double>::pi / 180;
    const auto rounded = [isFree] (double value, double step) { return isFree ? value : toStep (value, step); };

    if (held == Handle::turn)
        ceramic.angle = rounded (std::atan2 (-offset.x(), offset.y()) / radians, angleStep);
    else
    {
        const Eigen::Vector2d along = Eigen::Rotation2Dd (-ceramic.angle * radians) * offset;
        const auto isRound = ceramic.shape != CeramicShape::rectangle;
        const auto least = gridStep;
        ceramic.size.x() = std::max (least, rounded (2 * (isRound ? along.norm() : std::abs (along.x())), gridStep));

        if (isRound)
            ceramic.size.y() = ceramic.size.x();
        else if (! isLine())
            ceramic.size.y() = std::max (least, rounded (2 * std::abs (along.y()), gridStep));
    }

    draft.drag (withCeramic (heldDocument, index, ceramic));
}

void DeviceSurface::mouseDrag (const juce::MouseEvent& event)
{
    const auto isFree = event.mods.isAltDown();
    const Eigen::Vector2d by = millimetresAt (event.position) - heldAt;

    if (held == Handle::spot)
        return SurfaceView::mouseDrag (event);

    if (held == Handle::none || (! draft.isEdited() && event.getDistanceFromDragStart() < 2))
        return;

    if (held == Handle::ceramic)
        dragCeramics (by, isFree);
    else if (held == Handle::size || held == Handle::turn)
        dragCorner (event.position, isFree);
    else if (held == Handle::point && draft.point)
    {
        auto point = pointsOf (heldDocument)[*draft.point];
        point.place = snapped (point.place + by, isFree);
        draft.drag (withPoint (heldDocument, *draft.point, point));
    }

    repaint();
}

void DeviceSurface::mouseUp (const juce::MouseEvent& event)
{
    SurfaceView::mouseUp (event);
    guides = {};

    if (std::exchange (held, Handle::none) != Handle::spot)
        draft.drop();

    repaint();
}

void DeviceSurface::removeSelected()
{
    if (draft.point)
        draft.apply (withoutPoint (draft.document(), *draft.point));
    else if (! draft.ceramics.empty())
        draft.removeCeramics (draft.ceramics);
}

bool DeviceSurface::keyPressed (const juce::KeyPress& key)
{
    if (! draft.isDrawn())
        return false;

    const auto code = key.getKeyCode();
    const auto step = key.getModifiers().isShiftDown() ? 0.1 : 1.0;
    const auto direction = [code] (int forwards, int backwards) { return (code == forwards) - (code == backwards); };
    const Eigen::Vector2d by (step * direction (juce::KeyPress::rightKey, juce::KeyPress::leftKey),
                              step * direction (juce::KeyPress::upKey, juce::KeyPress::downKey));

    if (code == juce::KeyPress::deleteKey || code == juce::KeyPress::backspaceKey)
        removeSelected();
    else if (by.any() && ! draft.ceramics.empty())
        draft.apply (withShifted (draft.document(), draft.ceramics, by));
    else
        return false;

    return true;
}

void DeviceSurface::addCeramic (CeramicShape shape, const Eigen::Vector2d& at)
{
    const auto& device = draft.document();
    const auto all = ceramicsOf (device);
    const auto like = draft.ceramics.empty() ? std::size_t { 0 } : *draft.ceramics.begin();
    constexpr double usual = 12; // mm
    DrawnCeramic more { shape, at, { usual, isLine() ? sizeOf (device).y() : usual } };

    if (like < all.size())
        more.size =
            shape == CeramicShape::rectangle ? all[like].size : Eigen::Vector2d::Constant (all[like].size.x()).eval();

    draft.apply (withMoreCeramic (device, more, like));
}

void DeviceSurface::addPoint (const DrawnPoint& more)
{
    draft.apply (withPoint (draft.document(), pointsOf (draft.document()).size(), more));
}

juce::PopupMenu DeviceSurface::edgeMenu()
{
    juce::PopupMenu menu;
    menu.addSectionHeader ("Edge " + fromUtf8 (draft.edge));
    const auto* const now = usualSupport (supportOf (draft.document(), draft.edge));

    for (const auto& usual : usualSupports())
        if (usual.isOfPlates)
            menu.addItem (fromUtf8 (usual.name), true, &usual == now,
                          [this, &usual]
                          { draft.apply (withSupport (draft.document(), draft.edge, supportJson (usual))); });

    return menu;
}

juce::PopupMenu DeviceSurface::menuAt (juce::Point<float> at)
{
    juce::PopupMenu menu;
    const auto handle = handleAt (at);
    constexpr double footStiffness = 20, addedMass = 10; // N/mm, g

    if (handle == Handle::ceramic && ! draft.ceramics.empty())
    {
        for (const auto isLeftToRight : { true, false })
            if (isLeftToRight || ! isLine())
                menu.addItem (isLeftToRight ? "Mirror left and right" : "Mirror up and down", [this, isLeftToRight]
                              { draft.apply (withMirrored (draft.document(), draft.ceramics, isLeftToRight)); });

        menu.addItem ("Remove", [this] { removeSelected(); });
        return menu;
    }

    if (handle == Handle::point)
    {
        menu.addItem ("Remove", [this] { removeSelected(); });
        return menu;
    }

    if (! draft.edge.empty())
        return edgeMenu();

    const auto place = millimetresAt (at);
    const Eigen::Vector2d rounded (toStep (place.x(), gridStep), toStep (place.y(), gridStep));
    menu.addItem ("Add a rectangular ceramic", [this, rounded] { addCeramic (CeramicShape::rectangle, rounded); });

    if (isLine())
        return menu;

    menu.addItem ("Add a round ceramic", [this, rounded] { addCeramic (CeramicShape::disc, rounded); });
    menu.addItem ("Add a foot", [this, rounded] { addPoint ({ rounded, footStiffness, 0 }); });
    menu.addItem ("Add a mass", [this, rounded] { addPoint ({ rounded, 0, addedMass }); });
    return menu;
}
} // namespace antinode
