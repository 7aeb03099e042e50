#pragma once

#include "DevicePath.h"

#include <antinode_engine/MotionCapture.h>
#include <antinode_engine/SafetyRamp.h>
#include <antinode_graph/SurfaceNode.h>

#include <memory>
#include <vector>

namespace antinode
{
/** What takes effect at once. */
struct SurfaceControls
{
    bool isArmed = true; ///< False: all voltages ramp to 0, and the surface rings out.
    double gain = 1;     ///< Factor of the velocities.
};

/** How a surface is computed. */
enum class SurfaceModel
{
    asRendered, ///< As `antinode render` does, 15 samples late.
    quick       ///< Without delay and at a fraction of the cost, within some parts in a thousand.
};

/** A device under voltages from outside: limiter, surface, probes, and the motion that is captured. */
class PlatePath : public DevicePath
{
public:
    static constexpr int probes = LevelMeters::probes;
    static constexpr int capturedFrames = 121;      ///< Of a window,
    static constexpr double capturedSeconds = 0.02; ///< which is about so long.

    /** @param probeShapes  8 x N_m, kg^-1/2
        @throws InputError  when the device or the rate cannot be played
        [worker] */
    PlatePath (std::shared_ptr<const ModalModel>, double sampleRate, const Eigen::MatrixXd& probeShapes, SurfaceModel);

    SurfaceNode& surface() { return static_cast<SurfaceNode&> (graph.node (plate)); }
    std::int64_t latencySamples()
    {
        return surface().latencySamples() + (acting == limiter ? 0 : graph.node (acting).latencySamples());
    }

    /** Where windows of the motion are taken from; outlives the path. [any] */
    std::shared_ptr<MotionCapture> motion() const { return capture; }

    /** s from one frame of a window to the next. [any] */
    double captureStep() const { return stride / rate; }

    /** Plays a block of any length.
        @param isLeaving  from now on the velocities ramp to 0
        [audio thread] allocates nothing, locks nothing */
    template <typename Sample>
    void process (const AudioBlock<Sample>&, const SurfaceControls&, bool isLeaving, LevelMeters&);

private:
    template <typename Sample>
    void writeVelocities (const AudioBlock<Sample>&, int offset, int count, Outputs velocities);
    void captureMotion (int count);

    int stride; ///< Samples from one captured frame to the next.
    NodeGraph graph;
    int input = 0, limiter = 0, acting = 0,
        plate = 0; ///< Indices of its nodes; acting: what gives the ceramics' voltages.
    std::shared_ptr<MotionCapture> capture;
    std::vector<double> velocities; ///< Of the modes.
    PlanarBuffer<double> heard;     ///< At the probes, with the ramp.
    SafetyRamp ramp { 1 };
    bool isRamping = false;
    int sinceFrame = 0; ///< Samples.
    double gain = 1;
};
} // namespace antinode
