#include "PlateWorker.h"

#include "FocusSettings.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_library/Library.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace antinode
{
namespace
{
constexpr auto interval = std::chrono::milliseconds (4);  // between looks at the parameters
constexpr auto patience = std::chrono::milliseconds (40); // of a host that prepares us

/** @throws InputError  where it cannot be solved, or has nothing that moves it */
std::shared_ptr<const ModalModel> solved (const DeviceDocument& document)
{
    auto model = std::make_shared<const ModalModel> (solveDevice (document.description, {}, true));

    if (model->actuators() == 0)
        throw InputError ("device '" + document.description.name + "'", "has no ceramics, so nothing can move it");

    return model;
}
} // namespace

PlateWorker::PlateWorker (std::shared_ptr<const DeviceDocument> device, std::shared_ptr<Owner> ownerToAsk)
    : owner (std::move (ownerToAsk)), nextDevice (std::move (device)),
      published (std::make_shared<const PlateSnapshot>())
{
}

void PlateWorker::stop()
{
    const std::lock_guard lock (mutex);
    isStopping = true;
    wake.notify_all();
}

void PlateWorker::load (std::shared_ptr<const DeviceDocument> device)
{
    const std::lock_guard lock (mutex);
    nextDevice = std::move (device);
    wake.notify_all();
}

void PlateWorker::prepare (double sampleRate)
{
    preparedRate = sampleRate;
    paths.reset();
    std::unique_lock lock (mutex);
    wantedRate = sampleRate;
    const auto round = ++roundsRequested;
    wake.notify_all();
    settled.wait_for (lock, patience, [&] { return roundsDone >= round; });
}

void PlateWorker::waitUntilSettled()
{
    std::unique_lock lock (mutex);
    const auto round = ++roundsRequested;
    wake.notify_all();
    settled.wait (lock, [&] { return roundsDone >= round; });
}

std::shared_ptr<const PlateSnapshot> PlateWorker::snapshot() const
{
    const std::lock_guard lock (mutex);
    return published;
}

void PlateWorker::run()
{
    const WatchScope scope ([this] { return ! isStopping; });

    try
    {
        for (std::uint64_t round = 0; awaitRound (round);)
        {
            step();
            const std::lock_guard lock (mutex);
            roundsDone = round;
            settled.notify_all();
        }
    }
    catch (const Cancelled&)
    {
        // It is stopping.
    }

    paths.clear();
}

/** @return  false at the end */
bool PlateWorker::awaitRound (std::uint64_t& round)
{
    std::unique_lock lock (mutex);
    wake.wait_for (lock, interval, [this] { return isStopping || nextDevice || roundsRequested > roundsDone; });
    round = roundsRequested;
    return ! isStopping;
}

/** One round: what was loaded, then the sample rate, then what the parameters say. */
void PlateWorker::step()
{
    if (takeDocument())
        solve();

    paths.collect();
    const auto before = std::exchange (settings, owner->settings (settings));
    double wanted = 0;
    {
        const std::lock_guard lock (mutex);
        wanted = wantedRate;
    }

    if (present.model == nullptr || ! (wanted > 0))
        return;

    if (isModelNew || rate != wanted || before.model != settings.model)
        buildPath (wanted);
    else if (path != nullptr && before.probes != settings.probes)
        moveProbes();
}

/** @return  whether there is another document now */
bool PlateWorker::takeDocument()
{
    const std::lock_guard lock (mutex);

    if (nextDevice == nullptr)
        return false;

    present.device = std::exchange (nextDevice, nullptr);
    return true;
}

/** A newer device ends this one's solving; the next round takes it. */
void PlateWorker::solve()
{
    present.isSolving = true;
    publish();

    try
    {
        const WatchScope scope (
            [this]
            {
                const std::lock_guard lock (mutex);
                return nextDevice == nullptr;
            });
        present.model = solved (*present.device);
        present.error.clear();
        isModelNew = true;
    }
    catch (const Cancelled&)
    {
        checkWatch();
    }
    catch (const std::exception& failure)
    {
        present.error = failure.what();
    }

    present.isSolving = false;
    publish();
}

void PlateWorker::buildPath (double sampleRate)
{
    rate = sampleRate; // Also where it fails: nobody shall try it again every few milliseconds.
    isModelNew = false;

    try
    {
        auto made = std::make_unique<PlatePath> (present.model, sampleRate, probeShapes(), settings.model);
        path = made.get();
        latency = path->latencySamples();
        tail = std::log (1000) / decayRates (*present.model).minCoeff();
        present.motion = path->motion();
        present.captureStep = path->captureStep();
        paths.give (std::move (made));
    }
    catch (const std::exception& failure)
    {
        present.error = failure.what();
    }

    publish();
}

void PlateWorker::moveProbes()
{
    path->surface().setProbes (probeShapes());
}

Eigen::MatrixXd PlateWorker::probeShapes() const
{
    const auto& model = *present.model;
    Eigen::MatrixXd shapes (PlatePath::probes, model.coordinates());

    for (std::size_t i = 0; i < settings.probes.size(); ++i)
    {
        const auto [x, y] = placeFromPercent (model.surface, static_cast<double> (settings.probes[i].first),
                                              static_cast<double> (settings.probes[i].second));
        shapes.row (static_cast<Eigen::Index> (i)) = shapesAt (model, x, y);
    }

    return shapes;
}

void PlateWorker::publish()
{
    {
        const std::lock_guard lock (mutex);
        published = std::make_shared<const PlateSnapshot> (present);
    }
    owner->tell();
}

template <typename Sample>
void PlateWorker::process (const SurfaceBlock<Sample>& block, const SurfaceControls& controls)
{
    if (auto* const current = paths.current (preparedRate, block.count))
    {
        current->process (block, controls, paths.isLeaving(), levels);
        return;
    }

    for (auto* const channel : block.probes)
        std::fill_n (channel, block.count, Sample (0));
}

template void PlateWorker::process (const SurfaceBlock<float>&, const SurfaceControls&);
template void PlateWorker::process (const SurfaceBlock<double>&, const SurfaceControls&);
} // namespace antinode
