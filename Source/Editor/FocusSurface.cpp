#include "FocusSurface.h"

#include "EditorLook.h"

#include <Processor/ParameterSet.h>
#include <antinode_base/InputError.h>
#include <antinode_base/Prefixes.h>
#include <antinode_reports/Lettering.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr float smallestRadius = 10; // pixels: what can be hit

float shownRadius (const Finger& finger, const PlotFrame& plot)
{
    return std::max (smallestRadius, plot.xAt (finger.radius * milli) - plot.xAt (0));
}

bool isAmong (const std::vector<Finger>& fingers, const Finger& wanted)
{
    return std::find (fingers.begin(), fingers.end(), wanted) != fingers.end();
}
} // namespace

SurfaceFingers::SurfaceFingers (AntinodeProcessor& processorToChange, History& historyToWrite)
    : processor (processorToChange), history (historyToWrite)
{
}

bool SurfaceFingers::refresh()
{
    auto loaded = processor.focus();

    if (dragged || loaded == shown)
        return false;

    shown = std::move (loaded);
    return std::exchange (fingers, shown->description.fingers) != fingers;
}

Surface SurfaceFingers::surface() const
{
    return deviceExtent (processor.device()->description);
}

juce::Point<float> SurfaceFingers::middle (std::size_t finger, const PlotFrame& plot) const
{
    const auto& each = fingers[finger];
    return plot.at (each.x * milli, surface().kind == SurfaceKind::line ? 0 : each.y * milli);
}

std::optional<std::size_t> SurfaceFingers::at (juce::Point<float> place, const PlotFrame& plot) const
{
    std::optional<std::size_t> nearest;
    auto least = 0.0f;

    for (std::size_t i = 0; i < fingers.size(); ++i)
    {
        const auto distance = place.getDistanceFrom (middle (i, plot));

        if (distance <= shownRadius (fingers[i], plot) && (! nearest || distance < least))
        {
            nearest = i;
            least = distance;
        }
    }

    return nearest;
}

void SurfaceFingers::apply (std::vector<Finger> wanted)
{
    juce::String refusal;

    // A touch may have left since it was shown, as while another finger was dragged.
    if (const auto now = processor.focus(); shown != nullptr)
        std::erase_if (
            wanted, [&] (const auto& finger)
            { return isAmong (shown->description.fingers, finger) && ! isAmong (now->description.fingers, finger); });

    try
    {
        validate (wanted, surface());
        history.record ([&] { processor.setFingers (wanted); });
    }
    catch (const InputError& failure)
    {
        refusal = fromUtf8 (failure.what());
    }

    if (say)
        say (refusal);

    shown = nullptr;
    refresh();
}

/** A menu may speak of a finger that is not there any more. */
void SurfaceFingers::change (std::size_t finger, const std::function<void (Finger&)>& edit)
{
    if (finger >= fingers.size())
        return;

    auto wanted = fingers;
    edit (wanted[finger]);
    apply (std::move (wanted));
}

void SurfaceFingers::rest (const std::string& kind, double x, double y)
{
    auto wanted = fingers;
    wanted.push_back (builtInFinger (kind, x, surface().kind == SurfaceKind::line ? 0 : y));
    apply (std::move (wanted));
}

void SurfaceFingers::lift (std::size_t finger)
{
    if (finger >= fingers.size())
        return;

    auto wanted = fingers;
    wanted.erase (wanted.begin() + static_cast<std::ptrdiff_t> (finger));
    apply (std::move (wanted));
}

void SurfaceFingers::liftAll()
{
    apply ({});
}

void SurfaceFingers::setKind (std::size_t finger, const std::string& kind)
{
    change (finger,
            [&] (Finger& each)
            {
                const auto isKnown = each.isKnown;
                each = builtInFinger (kind, each.x, each.y);
                each.isKnown = isKnown;
            });
}

void SurfaceFingers::setKnown (std::size_t finger, bool isKnown)
{
    change (finger, [isKnown] (Finger& each) { each.isKnown = isKnown; });
}

void SurfaceFingers::drag (std::size_t finger, double x, double y)
{
    dragged = finger;
    fingers[finger].x = x;
    fingers[finger].y = y;
}

void SurfaceFingers::drop()
{
    const auto finger = std::exchange (dragged, std::nullopt);

    if (! finger)
        return;

    if (liesOn (surface(), fingers[*finger].x, fingers[*finger].y))
        apply (fingers);
    else
        lift (*finger);
}

void SurfaceFingers::paint (juce::Graphics& g, const PlotFrame& plot, const Palette& palette) const
{
    const auto extent = surface();

    for (std::size_t i = 0; i < fingers.size(); ++i)
    {
        const auto& finger = fingers[i];
        const auto radius = shownRadius (finger, plot);
        const auto disc = juce::Rectangle<float> (2 * radius, 2 * radius).withCentre (middle (i, plot));
        g.setColour (palette.window.withAlpha (liesOn (extent, finger.x, finger.y) ? 0.35f : 0.1f));
        g.fillEllipse (disc);
        g.setColour (palette.text.withAlpha (finger.isKnown ? 0.9f : 0.5f));
        g.drawEllipse (disc, finger.isKnown ? 2.0f : 1.0f);
        drawText (g, finger.isKnown ? finger.name : finger.name + ", unknown",
                  disc.withSizeKeepingCentre (120, 14).withY (disc.getBottom() + 1), juce::Justification::centred,
                  { 11, false, palette.text });
    }
}

namespace
{
constexpr auto ringRadius = 9.0f; // of spot and probe, which lie above fingers

juce::String capitalised (const char* word)
{
    const juce::String text (word);
    return text.substring (0, 1).toUpperCase() + text.substring (1);
}
} // namespace

FocusSurface::FocusSurface (AntinodeProcessor& processor, History& history)
    : SurfaceView (
        "Velocity of the surface at the focus. Arrow keys move the spot, Alt with arrow keys the probe, Shift makes "
        "the steps smaller. N rests a finger at the probe, Delete lifts the one nearest to it. Space fires.",
        "Drag the spot (ring), the probe (diamond) or a finger (disc); a right click rests and lifts "
        "fingers.\nArrow keys move the spot by 1 % of the surface, with Shift by "
        "0.1 %; Alt with arrow keys moves the probe. Space fires.",
        true),
      touching (processor, history)
{
    const auto& parameters = processor.parameters();
    spotPlace = { parameters.find ("x"), parameters.find ("y") };
    probePlace = { parameters.find ("probe_x"), parameters.find ("probe_y") };
    width = parameters.find ("width");
    height = parameters.find ("peak_velocity");
    setWantsKeyboardFocus (true);
}

std::array<double, 6> FocusSurface::values() const
{
    return { parameterValue (*spotPlace.x),  parameterValue (*spotPlace.y), parameterValue (*probePlace.x),
             parameterValue (*probePlace.y), parameterValue (*width),       parameterValue (*height) };
}

void FocusSurface::refresh()
{
    const auto now = values();

    if (touching.refresh() || std::exchange (shownValues, now) != now)
        repaint();
}

juce::Point<float> FocusSurface::spot() const
{
    return pixels (spotPlace, parameterValue (*height));
}

std::unique_ptr<juce::AccessibilityHandler> FocusSurface::createAccessibilityHandler()
{
    return std::make_unique<juce::AccessibilityHandler> (
        *this, juce::AccessibilityRole::image,
        juce::AccessibilityActions().addAction (juce::AccessibilityActionType::press,
                                                [this]
                                                {
                                                    if (onFire)
                                                        onFire();
                                                }));
}

void FocusSurface::paintOnTop (juce::Graphics& g)
{
    touching.paint (g, plot(), EditorLook::findPalette (*this));
    paintProbe (g);
    paintSpot (g);
}

void FocusSurface::paintSpot (juce::Graphics& g) const
{
    const auto& palette = EditorLook::findPalette (*this);
    const auto centre = spot();
    const auto halfWidth = std::abs (plot().xAt (0.5 * parameterValue (*width)) - plot().xAt (0));
    g.saveState();
    g.reduceClipRegion (plot().plot.expanded (10).getSmallestIntegerContainer());
    g.setColour (palette.fire.withAlpha (0.8f));

    if (isLine())
    {
        const auto half = plot().yAt (0.5 * parameterValue (*height));
        g.fillRect (juce::Rectangle<float> (2 * halfWidth, 1.5f).withCentre ({ centre.x, half }));
        g.fillRect (juce::Rectangle<float> (centre.x - 0.5f, centre.y, 1, plot().yAt (0) - centre.y));
    }
    else
    {
        juce::Path ring, dashes;
        ring.addEllipse (juce::Rectangle<float> (2 * halfWidth, 2 * halfWidth).withCentre (centre));
        constexpr float pattern[] = { 5, 4 };
        juce::PathStrokeType (1.3f).createDashedStroke (dashes, ring, pattern, 2);
        g.fillPath (dashes);
    }

    g.setColour (palette.window.withAlpha (0.85f));
    g.drawEllipse (juce::Rectangle<float> (15, 15).withCentre (centre), 4.5f);
    g.setColour (palette.fire);
    g.drawEllipse (juce::Rectangle<float> (15, 15).withCentre (centre), 2.5f);
    g.fillEllipse (juce::Rectangle<float> (4, 4).withCentre (centre));
    g.restoreState();
}

void FocusSurface::paintProbe (juce::Graphics& g) const
{
    const auto& palette = EditorLook::findPalette (*this);
    const auto centre = probe();
    juce::Path diamond;
    diamond.addQuadrilateral (centre.x - 7, centre.y, centre.x, centre.y - 7, centre.x + 7, centre.y, centre.x,
                              centre.y + 7);
    g.setColour (palette.window.withAlpha (0.85f));
    g.strokePath (diamond, juce::PathStrokeType (4));
    g.setColour (palette.armed);
    g.strokePath (diamond, juce::PathStrokeType (2));
}

FocusSurface::Handle FocusSurface::handleAt (juce::Point<float> place) const
{
    if (! isShown() || ! plot().plot.expanded (grabRadius).contains (place))
        return Handle::none;

    // The spot may be dragged from anywhere: what is near the probe alone is the probe's.
    const auto toSpot = place.getDistanceFrom (spot()), toProbe = place.getDistanceFrom (probe());

    if (std::min (toSpot, toProbe) > ringRadius && fingerAt (place))
        return Handle::finger;

    return toProbe < grabRadius && toProbe < toSpot ? Handle::probe : Handle::spot;
}

void FocusSurface::mouseMove (const juce::MouseEvent& event)
{
    setMouseCursor (handleAt (event.position) == Handle::none ? juce::MouseCursor::NormalCursor
                                                              : juce::MouseCursor::PointingHandCursor);
}

void FocusSurface::mouseDown (const juce::MouseEvent& event)
{
    const auto handle = handleAt (event.position);

    if (handle == Handle::none)
        return;

    if (event.mods.isPopupMenu())
    {
        fingerMenu (event.position)
            .showMenuAsync (juce::PopupMenu::Options().withMousePosition().withDeletionCheck (*this));
        return;
    }

    if (handle == Handle::finger)
    {
        draggedFinger = fingerAt (event.position);
        fingerFrom = event.position - touching.middle (*draggedFinger, plot());
        return;
    }

    const auto offset = event.position - (handle == Handle::probe ? probe() : spot());
    grab (handle == Handle::probe ? probePlace : spotPlace,
          offset.getDistanceFromOrigin() < grabRadius ? offset : juce::Point<float>());
    SurfaceView::mouseDrag (event);
}

void FocusSurface::mouseDrag (const juce::MouseEvent& event)
{
    if (! draggedFinger)
        return SurfaceView::mouseDrag (event);

    const auto at = metresAt (event.position - fingerFrom);
    touching.drag (*draggedFinger, at.x, at.y);
    repaint();
}

void FocusSurface::mouseUp (const juce::MouseEvent& event)
{
    if (! std::exchange (draggedFinger, std::nullopt))
        return SurfaceView::mouseUp (event);

    touching.drop();
    repaint();
}

/** A place of the surface or beside it, m. */
juce::Point<double> FocusSurface::metresAt (juce::Point<float> at) const
{
    const auto [x, y] = percentAt (at);
    const auto& extent = surface();
    return { extent.xMinimum + x / 100 * (extent.xMaximum - extent.xMinimum),
             isLine() ? 0 : extent.yMinimum + y / 100 * (extent.yMaximum - extent.yMinimum) };
}

void FocusSurface::nudge (const Place& place, double xPercent, double yPercent)
{
    grab (place, {});
    move (place, parameterValue (*place.x) + xPercent, parameterValue (*place.y) + yPercent);
    release();
}

bool FocusSurface::keyPressed (const juce::KeyPress& key)
{
    const auto code = key.getKeyCode();
    const auto step = key.getModifiers().isShiftDown() ? 0.1 : 1.0;
    const auto direction = [code] (int forwards, int backwards) { return (code == forwards) - (code == backwards); };
    const auto right = direction (juce::KeyPress::rightKey, juce::KeyPress::leftKey),
               up = direction (juce::KeyPress::upKey, juce::KeyPress::downKey);

    if (right != 0 || up != 0)
    {
        nudge (key.getModifiers().isAltDown() ? probePlace : spotPlace, right * step, up * step);
        return true;
    }

    if (changeFingers (key))
        return true;

    if (code != juce::KeyPress::spaceKey && code != juce::KeyPress::returnKey)
        return false;

    if (onFire)
        onFire();

    return true;
}

juce::PopupMenu FocusSurface::fingerMenu (juce::Point<float> place)
{
    juce::PopupMenu menu;

    if (! isShown())
        return menu;

    const auto at = metresAt (place);
    const auto finger = fingerAt (place);
    menu.addSectionHeader (finger ? "Finger" : "Rest a finger here");

    for (const auto& kind : fingerKinds)
        menu.addItem (capitalised (kind.name), true, finger && touching.all()[*finger].name == kind.name,
                      [this, at, finger, name = std::string (kind.name)]
                      {
                          if (finger)
                              touching.setKind (*finger, name);
                          else
                              touching.rest (name, at.x, at.y);
                      });

    menu.addSeparator();

    if (finger)
    {
        const auto isKnown = touching.all()[*finger].isKnown;
        menu.addItem ("Known to the design", true, isKnown,
                      [this, finger, isKnown] { touching.setKnown (*finger, ! isKnown); });
        menu.addItem ("Lift", [this, finger] { touching.lift (*finger); });
    }
    else
        menu.addItem ("Lift all fingers", ! touching.all().empty(), false, [this] { touching.liftAll(); });

    return menu;
}

/** N rests a finger at the probe, Delete lifts the one nearest to it. */
bool FocusSurface::changeFingers (const juce::KeyPress& key)
{
    const auto isLetter = key.getTextCharacter() == 'n' || key.getTextCharacter() == 'N';
    const auto isDelete = key == juce::KeyPress::deleteKey || key == juce::KeyPress::backspaceKey;

    if (! isShown() || ! (isLetter || isDelete) || key.getModifiers().isCommandDown())
        return false;

    const auto& all = touching.all();

    if (isLetter)
    {
        const auto at = metresAt (probe());
        touching.rest ("medium", at.x, at.y);
        return true;
    }

    if (all.empty())
        return false;

    std::size_t nearest = 0;
    const auto distance = [&] (std::size_t finger)
    { return probe().getDistanceFrom (touching.middle (finger, plot())); };

    for (std::size_t i = 1; i < all.size(); ++i)
        if (distance (i) < distance (nearest))
            nearest = i;

    touching.lift (nearest);
    return true;
}
} // namespace antinode
