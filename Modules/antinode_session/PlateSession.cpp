#include "PlateSession.h"

#include "FocusSettings.h"

#include <antinode_base/InputError.h>
#include <antinode_library/Library.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
/** @throws InputError  where it cannot be solved, or has nothing that moves it */
std::shared_ptr<const ModalModel> solvedForPlate (const DeviceDocument& document)
{
    auto model = std::make_shared<const ModalModel> (solveDevice (document.description, {}, true));

    if (model->actuators() == 0)
        throw InputError ("device '" + document.description.name + "'", "has no ceramics, so nothing can move it");

    return model;
}
} // namespace

PlateSession::PlateSession (DeviceDocument device, std::function<SurfaceSettings()> readSettings,
                            std::function<void()> onChange)
    : DeviceRounds (std::move (device), std::move (readSettings), std::move (onChange))
{
}

void PlateSession::prepare (double sampleRate)
{
    preparedRate = sampleRate;
    paths.reset();
    ask (sampleRate);
}

void PlateSession::run()
{
    const WatchScope scope ([this] { return ! isStopping; });

    try
    {
        for (std::uint64_t round = 0; awaitRound (round);)
        {
            step();
            finish (round);
        }
    }
    catch (const Cancelled&)
    {
        // It is stopping.
    }

    paths.clear();
}

/** One round: what was loaded, then the sample rate, then what the parameters say. */
void PlateSession::step()
{
    if (takeDocument())
        solve (solvedForPlate, [] {});

    takeAmplifiers();

    paths.collect();
    const auto before = std::exchange (settings, owner.settings (settings));
    const auto wanted = askedFor();

    if (present.model == nullptr || ! (wanted > 0))
        return;

    if (isModelNew || rate != wanted || before.model != settings.model)
        buildPath (wanted);
    else if (path != nullptr && before.probes != settings.probes)
        moveProbes();
}

void PlateSession::buildPath (double sampleRate)
{
    rate = sampleRate; // Also where it fails: nobody shall try it again every few milliseconds.
    isModelNew = false;

    try
    {
        auto made = std::make_unique<PlatePath> (present.model, sampleRate, probeShapes(), settings.model);
        path = made.get();
        latency = path->latencySamples();
        tail = static_cast<double> (latency) / sampleRate + std::log (1000) / decayRates (*present.model).minCoeff();
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

void PlateSession::moveProbes()
{
    path->surface().setProbes (probeShapes());
}

Eigen::MatrixXd PlateSession::probeShapes() const
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

template <typename Sample>
void PlateSession::process (const AudioBlock<Sample>& block, const SurfaceControls& controls)
{
    if (auto* const current = paths.current (preparedRate, block.count))
    {
        current->process (block, controls, paths.isLeaving(), levels);
        return;
    }

    block.silence();
}

template void PlateSession::process (const AudioBlock<float>&, const SurfaceControls&);
template void PlateSession::process (const AudioBlock<double>&, const SurfaceControls&);
} // namespace antinode
