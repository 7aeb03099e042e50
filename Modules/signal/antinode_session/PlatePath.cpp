#include "PlatePath.h"

#include <antinode_graph/InputNode.h>
#include <antinode_graph/LagNode.h>
#include <antinode_graph/PlateModelNode.h>
#include <antinode_graph/PlateNode.h>

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
} // namespace antinode
