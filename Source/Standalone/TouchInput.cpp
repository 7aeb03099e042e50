#include "TouchInput.h"

namespace antinode
{
std::pair<double, double> touchPlace (const Touch& touch, const Surface& surface)
{
    if (touch.inMillimetres)
        return { touch.x / 1000, touch.y / 1000 };

    // Weights, not a step from one end: so 0 and 1 are the very edges, which rounding must not leave.
    return { surface.xMinimum * (1 - touch.x) + surface.xMaximum * touch.x,
             surface.yMinimum * (1 - touch.y) + surface.yMaximum * touch.y };
}

void TouchInput::place (const Touch& touch)
{
    const auto model = session.snapshot()->model;

    if (model == nullptr)
    {
        ++notAccepted;
        return;
    }

    const auto [x, y] = touchPlace (touch, model->surface);

    if (touch.kind == TouchKind::rest)
    {
        const auto result = fingers.rest (touch.finger, x, y, model->surface);
        outsideSurface += result == RestResult::outsideSurface ? 1 : 0;
        withoutKind += result == RestResult::noKind ? 1 : 0;
        return;
    }

    const auto result = session.fireAt (x, y, touch.amplitude);
    outsideSurface += result == Session::FireResult::outsideSurface ? 1 : 0;
    notAccepted += result == Session::FireResult::notAccepted ? 1 : 0;
}

void TouchInput::play (const Touch& touch)
{
    if (touch.kind == TouchKind::stopAll)
        return session.stopAll();

    if (touch.kind == TouchKind::lift)
        return fingers.lift (touch.finger);

    place (touch);
}

void TouchInput::open (const TouchPorts& ports)
{
    receiver.reset();
    outsideSurface = 0;
    notAccepted = 0;
    withoutKind = 0;
    fingers.setKind (ports.finger);

    if (ports.oscPort == 0 && ports.tuioPort == 0)
        return;

    TouchOptions options;
    options.cursorsRest = ! ports.finger.empty();
    receiver = std::make_unique<TouchReceiver> (ports, options, [this] (const Touch& touch) { play (touch); });
}
} // namespace antinode
