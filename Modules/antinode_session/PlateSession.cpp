#include "PlateSession.h"

#include "PlateWorker.h"

#include <utility>

namespace antinode
{
PlateSession::PlateSession (DeviceDocument device, ReadSettings read, std::function<void()> changed)
    : owner (std::make_shared<SessionOwner<SurfaceSettings>> (std::move (read), std::move (changed))),
      worker (std::make_shared<PlateWorker> (std::make_shared<const DeviceDocument> (std::move (device)), owner)),
      thread ([kept = worker] { kept->run(); })
{
}

PlateSession::~PlateSession()
{
    worker->stop();
    owner->leave();
}

void PlateSession::load (std::shared_ptr<const DeviceDocument> device)
{
    worker->load (std::move (device));
}

void PlateSession::prepare (double sampleRate)
{
    worker->prepare (sampleRate);
}

template <typename Sample>
void PlateSession::process (const SurfaceBlock<Sample>& block, const SurfaceControls& controls)
{
    worker->process (block, controls);
}

void PlateSession::waitUntilSettled()
{
    worker->waitUntilSettled();
}

std::shared_ptr<const PlateSnapshot> PlateSession::snapshot() const
{
    return worker->snapshot();
}

LevelMeters& PlateSession::meters()
{
    return worker->meters();
}

std::int64_t PlateSession::latencySamples() const
{
    return worker->latencySamples();
}

double PlateSession::tailSeconds() const
{
    return worker->tailSeconds();
}

template void PlateSession::process (const SurfaceBlock<float>&, const SurfaceControls&);
template void PlateSession::process (const SurfaceBlock<double>&, const SurfaceControls&);
} // namespace antinode
