#pragma once

#include "DevicePath.h"
#include "DeviceRounds.h"

#include <antinode_engine/MotionCapture.h>
#include <antinode_engine/VoltageLimiter.h>
#include <antinode_graph/SurfaceNode.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
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

/** What the parameters of a host say of a surface. */
struct SurfaceSettings
{
    std::array<std::pair<float, float>, PlatePath::probes> probes {}; ///< x, y in % of the surface's extent.
    SurfaceModel model = SurfaceModel::asRendered;

    bool operator== (const SurfaceSettings&) const = default;
};

/** What a plate session plays just now, for those who look on. Never changed once it is given. */
struct PlateSnapshot
{
    std::shared_ptr<const DeviceDocument> device; ///< What was asked for, also while it is being solved.
    std::shared_ptr<const ModalModel> model;      ///< None before the first device is solved.
    std::shared_ptr<MotionCapture> motion;        ///< None before a host has prepared it.
    double captureStep = 0;                       ///< s from one captured frame to the next.
    bool isSolving = false;
    std::string error; ///< Why the device that was asked for cannot be played: then the one before plays on.
};

/** A device as an effect: solves it, and lets voltages from outside move it. A thread of its own looks at the
   parameters every few milliseconds, solves and builds; paths go to the audio thread by one atomic exchange; and
   nothing here waits longer than a moment for that thread. SessionThread makes it, for it lasts as long as its thread.
 */
class PlateSession : public DeviceRounds<PlateSnapshot, SurfaceSettings, double>
{
public:
    using DeviceRounds::DeviceRounds;

    /** Brings the surface to rest, and asks for the path of a sample rate. Waits for it, but only a moment. Nothing
        may be processing. [worker] */
    void prepare (double sampleRate);

    /** Moves the surface, or gives silence where there is none yet. [audio thread] allocates nothing, locks nothing */
    template <typename Sample>
    void process (const AudioBlock<Sample>&, const SurfaceControls&);

    LevelMeters& meters() { return levels; }

    /** By how many samples the velocities lag the voltages. [any] */
    std::int64_t latencySamples() const { return latency; }

    /** The latency and 60 dB of the slowest mode's decay, s. [any] */
    double tailSeconds() const { return tail; }

private:
    void work() override;
    void clear() override { paths.clear(); }
    void buildPath (double sampleRate);
    void moveProbes();
    Eigen::MatrixXd probeShapes() const;

    double rate = 0;           ///< Hz, of the path.
    PlatePath* path = nullptr; ///< The newest one, which `paths` owns.

    PathExchange<PlatePath> paths;
    LevelMeters levels;
    std::atomic<double> preparedRate { 0 }, tail { 1 };
    /** Until a path is there: that of the surface as rendered, the reach of its reconstruction. */
    std::atomic<std::int64_t> latency { 15 };
};
} // namespace antinode
