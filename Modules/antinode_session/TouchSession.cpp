#include "TouchSession.h"

#include "TouchWorker.h"

#include <utility>

namespace antinode
{
TouchSession::TouchSession (DeviceDocument device, ReadSettings read, std::function<void()> changed)
    : owner (std::make_shared<SessionOwner<TouchSettings>> (std::move (read), std::move (changed))),
      worker (std::make_shared<TouchWorker> (std::make_shared<const DeviceDocument> (std::move (device)), owner)),
      thread ([kept = worker] { kept->run(); })
{
}

TouchSession::~TouchSession()
{
    worker->stop();
    owner->leave();
}

void TouchSession::load (std::shared_ptr<const DeviceDocument> device)
{
    worker->load (std::move (device));
}

void TouchSession::prepare (double sampleRate, int inputs)
{
    worker->prepare (sampleRate, inputs);
}

template <typename Sample>
void TouchSession::process (const TouchBlock<Sample>& block, const TouchControls& controls)
{
    worker->process (block, controls);
}

void TouchSession::stopAll()
{
    stops().stop();
}

StopCount& TouchSession::stops() const
{
    return worker->stops();
}

void TouchSession::waitUntilSettled (std::span<const FocusEvent> notes)
{
    worker->waitUntilSettled (notes);
}

void TouchSession::loadFocus (std::shared_ptr<const FocusDocument> focus)
{
    worker->loadFocus (std::move (focus));
}

std::shared_ptr<const FocusDocument> TouchSession::focus() const
{
    return worker->focus();
}

DesignProgress TouchSession::focusProgress() const
{
    return worker->focusProgress();
}

FociUnderFingers TouchSession::fociUnderFingers() const
{
    return worker->fociUnderFingers();
}

void TouchSession::setComparing (bool shouldCompare)
{
    worker->setComparing (shouldCompare);
}

void TouchSession::setAmplifiers (std::vector<double> volts)
{
    worker->setAmplifiers (std::move (volts));
}

FollowingRequests& TouchSession::following() const
{
    return worker->following();
}

std::shared_ptr<const TouchSnapshot> TouchSession::snapshot() const
{
    return worker->snapshot();
}

double TouchSession::fullScaleVolts() const
{
    return worker->fullScaleVolts();
}

LevelMeters& TouchSession::meters()
{
    return worker->meters();
}

FingerMeters& TouchSession::fingerMeters()
{
    return worker->fingerMeters();
}

std::int64_t TouchSession::latencySamples (std::size_t latency) const
{
    return worker->latencySamples (latency);
}

double TouchSession::tailSeconds (std::size_t latency) const
{
    return worker->tailSeconds (latency);
}

template void TouchSession::process (const TouchBlock<float>&, const TouchControls&);
template void TouchSession::process (const TouchBlock<double>&, const TouchControls&);
} // namespace antinode
