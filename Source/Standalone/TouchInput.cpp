#include "TouchInput.h"

namespace antinode
{
std::pair<double, double> placeOf (const Touch& touch, const Surface& surface)
{
    if (touch.inMillimetres)
        return { touch.x / 1000, touch.y / 1000 };

    // Weights, not a step from one end: so 0 and 1 are the very edges, which rounding must not leave.
    return { surface.xMinimum * (1 - touch.x) + surface.xMaximum * touch.x,
             surface.yMinimum * (1 - touch.y) + surface.yMaximum * touch.y };
}

void play (const Touch& touch, Session& session)
{
    if (touch.kind == TouchKind::stopAll)
        return session.stopAll();

    if (const auto now = session.snapshot(); now->model != nullptr)
    {
        const auto [x, y] = placeOf (touch, now->model->surface);
        session.fireAt (x, y, touch.amplitude);
    }
}

void TouchInput::open (const TouchPorts& ports)
{
    receiver.reset();

    if (ports.oscPort != 0 || ports.tuioPort != 0)
        receiver = std::make_unique<TouchReceiver> (ports, TouchOptions {},
                                                    [this] (const Touch& touch) { play (touch, session); });
}
} // namespace antinode
