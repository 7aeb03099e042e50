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

void TouchInput::play (const Touch& touch)
{
    if (touch.kind == TouchKind::stopAll)
        return session.stopAll();

    const auto now = session.snapshot();
    auto result = Session::TouchResult::notAccepted;

    if (now->model != nullptr)
    {
        const auto [x, y] = touchPlace (touch, now->model->surface);
        result = session.fireAt (x, y, touch.amplitude);
    }

    outsideSurface += result == Session::TouchResult::outsideSurface ? 1 : 0;
    notAccepted += result == Session::TouchResult::notAccepted ? 1 : 0;
}

void TouchInput::open (const TouchPorts& ports)
{
    receiver.reset();
    outsideSurface = 0;
    notAccepted = 0;

    if (ports.oscPort != 0 || ports.tuioPort != 0)
        receiver =
            std::make_unique<TouchReceiver> (ports, TouchOptions {}, [this] (const Touch& touch) { play (touch); });
}
} // namespace antinode
