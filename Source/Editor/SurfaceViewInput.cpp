#include "SurfaceView.h"

#include <Processor/ParameterValues.h>

namespace antinode
{
namespace
{
constexpr auto grabRadius = 14.0f;

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
    return toProbe < grabRadius && toProbe < toSpot ? Handle::probe : Handle::spot;
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

    const auto middle = dragged == Handle::probe ? probe() : spot();
    grabbedAt = event.position.getDistanceFrom (middle) < grabRadius ? event.position - middle : juce::Point<float>();
    (dragged == Handle::probe ? probeX : spotX)->beginChangeGesture();
    (dragged == Handle::probe ? probeY : spotY)->beginChangeGesture();
    moveHandle (event.position);
}

void SurfaceView::mouseDrag (const juce::MouseEvent& event)
{
    if (dragged != Handle::none)
        moveHandle (event.position);
}

void SurfaceView::mouseUp (const juce::MouseEvent&)
{
    if (dragged == Handle::none)
        return;

    (dragged == Handle::probe ? probeX : spotX)->endChangeGesture();
    (dragged == Handle::probe ? probeY : spotY)->endChangeGesture();
    dragged = Handle::none;
}

void SurfaceView::moveHandle (juce::Point<float> place)
{
    const auto& plot = painter.frame().plot;
    const auto at = place - grabbedAt;
    setValue (dragged == Handle::probe ? *probeX : *spotX, 100 * (at.x - plot.getX()) / plot.getWidth());

    if (! painter.isLine())
        setValue (dragged == Handle::probe ? *probeY : *spotY, 100 * (plot.getBottom() - at.y) / plot.getHeight());

    refresh();
}

void SurfaceView::nudge (Handle handle, float xPercent, float yPercent)
{
    auto& x = handle == Handle::probe ? *probeX : *spotX;
    auto& y = handle == Handle::probe ? *probeY : *spotY;
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

    if (code != juce::KeyPress::spaceKey && code != juce::KeyPress::returnKey)
        return false;

    if (onFire)
        onFire();

    return true;
}
} // namespace antinode
