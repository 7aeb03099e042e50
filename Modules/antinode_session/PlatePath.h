#pragma once

#include "LevelMeters.h"

#include <antinode_engine/MotionCapture.h>
#include <antinode_engine/SafetyRamp.h>
#include <antinode_graph/InputNode.h>
#include <antinode_graph/LimiterNode.h>
#include <antinode_graph/NodeGraph.h>
#include <antinode_graph/SurfaceNode.h>
#include <antinode_model/ModalModel.h>

#include <cstdint>
#include <memory>
#include <span>

namespace antinode
{
/** Samples of a block on their way through a surface. */
template <typename Sample>
struct SurfaceBlock
{
    std::span<const Sample* const>
        voltages;                    ///< Channel k is ceramic k, 1.0 its device's full scale; missing ones get 0 V.
    std::span<Sample* const> probes; ///< Velocities, 1.0 = 1 m/s; may be the same memory as the voltages.
    int count = 0;                   ///< Samples.
};

/** What takes effect at once. */
struct SurfaceControls
{
    bool isPlaying = true; ///< False: all voltages ramp to 0, and the surface rings out.
    double gain = 1;       ///< Factor of the velocities.
};

/** How a surface is computed. */
enum class SurfaceModel
{
    asRendered, ///< As `antinode render` does, 15 samples late.
    quick       ///< Without delay and at a fraction of the cost, within some parts in a thousand.
};

/** One device at one sample rate under voltages from outside: limiter, surface, probes, and the motion that is
    captured. Made by the session, played by the audio thread, freed by the session. */
class PlatePath
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
    double sampleRate() const { return rate; }
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
    void process (const SurfaceBlock<Sample>&, const SurfaceControls&, bool isLeaving, LevelMeters&);

    /** Whether a ramp to silence that began so many samples ago has ended. [audio thread] */
    bool isSilentAfter (std::int64_t samples) const;

    /** The surface at rest. [audio thread] */
    void reset() { graph.reset(); }

private:
    using Outputs = const double* const*; ///< Of the graph: the voltages behind the limiter, then the probes.

    LimiterNode& limiterNode() { return static_cast<LimiterNode&> (graph.node (limiter)); }
    template <typename Sample>
    void write (const SurfaceBlock<Sample>&, int offset, int count, Outputs);
    void note (int count, Outputs, LevelMeters&);
    void captureMotion (int count);

    std::shared_ptr<const ModalModel> modes;
    double rate;
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
