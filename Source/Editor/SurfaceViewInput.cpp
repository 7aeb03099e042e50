#include "SurfaceView.h"

#include <Processor/ParameterSet.h>

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto grabRadius = 14.0f;
constexpr auto ringRadius = 9.0f; // of spot and probe, which lie above fingers

void setValue (juce::RangedAudioParameter& parameter, float value)
{
    const auto range = parameter.getNormalisableRange();
    parameter.setValueNotifyingHost (parameter.convertTo0to1 (juce::jlimit (range.start, range.end, value)));
}
} // namespace

SurfaceView::Handle SurfaceView::handleAt (juce::Point<float> place) const
{
    if (picture == nullptr || ! painter.frame().plot.expanded (grabRadius).contains (place))
        return Handle::none;

    // The spot may be dragged from anywhere: what is near the probe alone is the probe's.
    const auto toSpot = place.getDistanceFrom (spot()), toProbe = place.getDistanceFrom (probe());

    if (std::min (toSpot, toProbe) > ringRadius && fingerAt (place))
        return Handle::finger;

    return toProbe < grabRadius && toProbe < toSpot ? Handle::probe : Handle::spot;
}

std::optional<std::size_t> SurfaceView::fingerAt (juce::Point<float> place) const
{
    return touching.at (place, painter.frame());
}

juce::RangedAudioParameter* SurfaceView::horizontal (Handle handle) const
{
    return handle == Handle::probe ? probeX : spotX;
}

juce::RangedAudioParameter* SurfaceView::vertical (Handle handle) const
{
    return handle == Handle::probe ? probeY : spotY;
}

juce::Point<float> SurfaceView::middleOf (Handle handle) const
{
    if (handle == Handle::finger)
        return touching.middle (draggedFinger, painter.frame());

    return handle == Handle::probe ? probe() : spot();
}

void SurfaceView::mouseMove (const juce::MouseEvent& event)
{
    setMouseCursor (handleAt (event.position) == Handle::none ? juce::MouseCursor::NormalCursor
                                                              : juce::MouseCursor::PointingHandCursor);
}

void SurfaceView::mouseDown (const juce::MouseEvent& event)
{
    dragged = handleAt (event.position);

    if (dragged == Handle::none)
        return;

    if (event.mods.isPopupMenu())
    {
        dragged = Handle::none;
        fingerMenu (event.position)
            .showMenuAsync (juce::PopupMenu::Options().withMousePosition().withDeletionCheck (*this));
        return;
    }

    draggedFinger = fingerAt (event.position).value_or (0);
    const auto middle = middleOf (dragged);
    const auto isGrabbed = dragged == Handle::finger || event.position.getDistanceFrom (middle) < grabRadius;
    grabbedAt = isGrabbed ? event.position - middle : juce::Point<float>();

    if (dragged == Handle::finger)
        return;

    horizontal (dragged)->beginChangeGesture();
    vertical (dragged)->beginChangeGesture();
    moveHandle (event.position);
}

void SurfaceView::mouseDrag (const juce::MouseEvent& event)
{
    if (dragged == Handle::finger)
        moveFinger (event.position);
    else if (dragged != Handle::none)
        moveHandle (event.position);
}

void SurfaceView::mouseUp (const juce::MouseEvent&)
{
    const auto released = std::exchange (dragged, Handle::none);

    if (released == Handle::finger)
    {
        touching.drop();
        repaint();
    }
    else if (released != Handle::none)
    {
        horizontal (released)->endChangeGesture();
        vertical (released)->endChangeGesture();
    }
}

void SurfaceView::moveHandle (juce::Point<float> place)
{
    const auto& plot = painter.frame().plot;
    const auto at = place - grabbedAt;
    setValue (*horizontal (dragged), 100 * (at.x - plot.getX()) / plot.getWidth());

    if (! painter.isLine())
        setValue (*vertical (dragged), 100 * (plot.getBottom() - at.y) / plot.getHeight());

    refresh();
}

void SurfaceView::moveFinger (juce::Point<float> place)
{
    const auto at = surfacePlace (place - grabbedAt);
    touching.drag (draggedFinger, at.x, at.y);
    repaint();
}

/** A place of the surface or beside it, m. */
juce::Point<double> SurfaceView::surfacePlace (juce::Point<float> place) const
{
    const auto& plot = painter.frame().plot;
    const auto& surface = picture->question.model->surface;
    const auto across = static_cast<double> ((place.x - plot.getX()) / plot.getWidth()),
               up = static_cast<double> ((plot.getBottom() - place.y) / plot.getHeight());
    return { surface.xMinimum + across * (surface.xMaximum - surface.xMinimum),
             painter.isLine() ? 0 : surface.yMinimum + up * (surface.yMaximum - surface.yMinimum) };
}

void SurfaceView::nudge (Handle handle, float xPercent, float yPercent)
{
    auto& x = *horizontal (handle);
    auto& y = *vertical (handle);
    x.beginChangeGesture();
    y.beginChangeGesture();
    setValue (x, static_cast<float> (parameterValue (x)) + xPercent);

    if (! painter.isLine())
        setValue (y, static_cast<float> (parameterValue (y)) + yPercent);

    x.endChangeGesture();
    y.endChangeGesture();
    refresh();
}

bool SurfaceView::keyPressed (const juce::KeyPress& key)
{
    const auto code = key.getKeyCode();
    const auto step = key.getModifiers().isShiftDown() ? 0.1f : 1.0f;
    const auto handle = key.getModifiers().isAltDown() ? Handle::probe : Handle::spot;
    const auto right =
        static_cast<float> (code == juce::KeyPress::rightKey) - static_cast<float> (code == juce::KeyPress::leftKey);
    const auto up =
        static_cast<float> (code == juce::KeyPress::upKey) - static_cast<float> (code == juce::KeyPress::downKey);

    if (right != 0 || up != 0)
    {
        nudge (handle, right * step, up * step);
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
} // namespace antinode
