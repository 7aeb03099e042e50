#include "PlatePath.h"

#include "BlockPeak.h"

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
    : modes (std::move (model)), rate (sampleRateToUse),
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
}

bool PlatePath::isSilentAfter (std::int64_t passed) const
{
    return static_cast<double> (passed) > 2 * LimiterNode::rampTime * rate;
}

template <typename Sample>
void PlatePath::process (const SurfaceBlock<Sample>& block, const SurfaceControls& controls, bool isLeaving,
                         LevelMeters& meters)
{
    static_cast<InputNode&> (graph.node (input)).give (block.voltages, modes->fullScaleVoltage);
    limiterNode().setArmed (controls.isPlaying);
    gain = controls.gain;

    if (isLeaving && ! std::exchange (isRamping, true))
        ramp.setTarget (0, std::llround (LimiterNode::rampTime * rate));

    graph.processParts<double> (block.count, {},
                                [&] (int offset, int count, Outputs outputs)
                                {
                                    write (block, offset, count, outputs);
                                    note (count, outputs, meters);
                                    captureMotion (count);
                                });
    meters.noteState (limiterNode().limiter().isMuted(), 0);
}

template <typename Sample>
void PlatePath::write (const SurfaceBlock<Sample>& block, int offset, int count, Outputs outputs)
{
    for (int i = 0; i < probes; ++i)
        std::copy_n (outputs[modes->actuators() + i], count, heard.channel (static_cast<std::size_t> (i)));

    ramp.process (heard.channels(), probes, count);

    for (std::size_t i = 0; i < block.probes.size(); ++i)
        for (int n = 0; n < count; ++n)
            block.probes[i][offset + n] = i < probes ? static_cast<Sample> (heard.channel (i)[n] * gain) : Sample (0);
}

void PlatePath::note (int count, Outputs outputs, LevelMeters& meters)
{
    const auto ceramics = static_cast<int> (modes->actuators());

    for (int i = 0; i < std::min (ceramics, LevelMeters::ceramics); ++i)
    {
        meters.notePeak (i, static_cast<float> (absolutePeak (outputs[i], count)));
        meters.addLimited (i, limiterNode().takeLimitedSamples (static_cast<std::size_t> (i)));
    }

    for (int i = 0; i < probes; ++i)
        meters.noteProbe (i, static_cast<float> (absolutePeak (outputs[ceramics + i], count)));
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

template void PlatePath::process (const SurfaceBlock<float>&, const SurfaceControls&, bool, LevelMeters&);
template void PlatePath::process (const SurfaceBlock<double>&, const SurfaceControls&, bool, LevelMeters&);
} // namespace antinode
