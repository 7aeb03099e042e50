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

Session::TouchResult TouchInput::placed (const Touch& touch)
{
    const auto now = session.snapshot();

    if (now->model == nullptr)
        return Session::TouchResult::notAccepted;

    const auto [x, y] = touchPlace (touch, now->model->surface);

    if (touch.kind == TouchKind::focusAt)
        return session.fireAt (x, y, touch.amplitude);

    return fingers.rest (touch.finger, x, y, now->model->surface) ? Session::TouchResult::taken
                                                                  : Session::TouchResult::notAccepted;
}

void TouchInput::play (const Touch& touch)
{
    if (touch.kind == TouchKind::stopAll)
        return session.stopAll();

    if (touch.kind == TouchKind::lift)
        return fingers.lift (touch.finger);

    const auto result = placed (touch);
    outsideSurface += result == Session::TouchResult::outsideSurface ? 1 : 0;
    notAccepted += result == Session::TouchResult::notAccepted ? 1 : 0;
}

void TouchInput::open (const TouchPorts& ports)
{
    receiver.reset();
    outsideSurface = 0;
    notAccepted = 0;
    fingers.setKind (ports.finger);

    if (ports.oscPort == 0 && ports.tuioPort == 0)
        return;

    TouchOptions options;
    options.cursorsRest = ! ports.finger.empty();
    receiver = std::make_unique<TouchReceiver> (ports, options, [this] (const Touch& touch) { play (touch); });
}
} // namespace antinode
