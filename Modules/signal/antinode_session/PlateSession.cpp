#include "PlateSession.h"

#include "FocusSettings.h"

#include <algorithm>
#include <utility>

namespace antinode
{
void PlateSession::prepare (double sampleRate)
{
    preparedRate = sampleRate;
    paths.reset();
    ask (sampleRate);
}

/** One round: what was loaded, then the sample rate, then what the parameters say. */
void PlateSession::work()
{
    if (takeDocument())
        solve ([] {});

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
        tail = static_cast<double> (latency) / sampleRate + path->ringingSeconds();
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
