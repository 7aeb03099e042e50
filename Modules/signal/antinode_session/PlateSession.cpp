#include "PlateSession.h"

#include "FocusSettings.h"

#include <antinode_graph/InputNodes.h>
#include <antinode_graph/OutputNodes.h>
#include <antinode_graph/SurfaceNode.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr double captureMemory = 3; // s, after which a smaller motion is shown again

std::unique_ptr<SurfaceNode> surfaceNode (const std::shared_ptr<const ModalModel>& model,
                                          const Eigen::MatrixXd& probeShapes, SurfaceModel kind)
{
    if (kind == SurfaceModel::quick)
        return std::make_unique<PlateNode> (model, probeShapes);

    return std::make_unique<PlateModelNode> (model, probeShapes);
}

} // namespace

PlatePath::PlatePath (std::shared_ptr<const ModalModel> model, double sampleRateToUse,
                      const Eigen::MatrixXd& probeShapes, SurfaceModel kind)
    : DevicePath (std::move (model), sampleRateToUse),
      stride (std::max (1, static_cast<int> (std::lround (rate * capturedSeconds / (capturedFrames - 1))))),
      capture (std::make_shared<MotionCapture> (static_cast<int> (modes->coordinates()), capturedFrames,
                                                captureMemory * rate / stride)),
      velocities (static_cast<std::size_t> (modes->coordinates())), heard (probes, stride)
{
    const auto ceramics = static_cast<int> (modes->actuators());
    input = graph.add (std::make_unique<InputNode> (ceramics), NodeGraph::noSource);
    limiter = graph.add (std::make_unique<LimiterNode> (voltageLimits (*modes)), input);
    acting = needsLagFilters (*modes) ? graph.add (std::make_unique<LagNode> (modes, LagDirection::apply), limiter)
                                      : limiter;
    plate = graph.add (surfaceNode (modes, probeShapes, kind), acting);
    graph.setOutputs ({ limiter, plate });
    graph.prepare ({ rate, stride });
    play (graph, limiter);
}

template <typename Sample>
void PlatePath::process (const AudioBlock<Sample>& block, const SurfaceControls& controls, bool isLeaving,
                         LevelMeters& meters)
{
    static_cast<InputNode&> (graph.node (input)).give (block.inputs, modes->fullScaleVoltage);
    setArmed (controls.isArmed);
    gain = controls.gain;

    if (isLeaving && ! std::exchange (isRamping, true))
        ramp.setTarget (0, std::llround (LimiterNode::rampTime * rate));

    graph.processParts (block.count, {},
                        [&] (int offset, int count, Outputs outputs)
                        {
                            const auto velocities = outputs + modes->actuators();
                            writeVelocities (block, offset, count, velocities);
                            noteVoltages (count, outputs, meters);

                            for (int i = 0; i < probes; ++i)
                                meters.noteProbe (i, static_cast<float> (absolutePeak (velocities[i], count)));

                            captureMotion (count);
                        });
    meters.noteState (static_cast<LimiterNode&> (graph.node (limiter)).limiter().isMuted(), 0);
}

template <typename Sample>
void PlatePath::writeVelocities (const AudioBlock<Sample>& block, int offset, int count, Outputs velocities)
{
    for (int i = 0; i < probes; ++i)
        std::copy_n (velocities[i], count, heard.channel (static_cast<std::size_t> (i)));

    ramp.process (heard.channels(), probes, count);

    for (std::size_t i = 0; i < block.outputs.size(); ++i)
        for (int n = 0; n < count; ++n)
            block.outputs[i][offset + n] = i < probes ? static_cast<Sample> (heard.channel (i)[n] * gain) : Sample (0);
}

/** Parts are a step long or, at the end of a block, shorter: frames lie within a part of where they belong. */
void PlatePath::captureMotion (int count)
{
    sinceFrame += count;

    if (sinceFrame < stride)
        return;

    sinceFrame -= stride;
    surface().modalVelocities (velocities);
    capture->write (velocities);
}

template void PlatePath::process (const AudioBlock<float>&, const SurfaceControls&, bool, LevelMeters&);
template void PlatePath::process (const AudioBlock<double>&, const SurfaceControls&, bool, LevelMeters&);

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
