#pragma once

#include "Documents.h"
#include "PlatePath.h"
#include "SessionOwner.h"

#include <antinode_base/BackgroundThread.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace antinode
{
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

class PlateWorker;

/** A device as an effect: solves it, and lets voltages from outside move it. As with Session, a thread of its own
    looks at the parameters every few milliseconds, solves and builds; paths go to the audio thread by one atomic
    exchange; and nothing here waits longer than a moment for that thread, which may end after the session. */
class PlateSession
{
public:
    using ReadSettings = std::function<SurfaceSettings()>;

    /** Starts solving.
        @param readSettings  gives what the parameters say; called on the session's thread, must not block
        @param onChange      called on the session's thread after latency or snapshot have changed
        [worker] starts a thread */
    PlateSession (DeviceDocument, ReadSettings readSettings, std::function<void()> onChange);
    ~PlateSession();
    PlateSession (const PlateSession&) = delete;
    PlateSession& operator= (const PlateSession&) = delete;

    /** Another device. Returns at once; the present one moves on until the other is solved. [any but the audio
        thread] */
    void load (std::shared_ptr<const DeviceDocument>);

    /** Brings the surface to rest, and asks for the path of a sample rate. Waits for it, but only a moment. Nothing
        may be processing. [worker] */
    void prepare (double sampleRate);

    /** Moves the surface, or gives silence where there is none yet. [audio thread] allocates nothing, locks nothing */
    template <typename Sample>
    void process (const SurfaceBlock<Sample>&, const SurfaceControls&);

    /** Waits until all that was loaded is taken up, with what the parameters say. [any but a real-time audio thread] */
    void waitUntilSettled();

    /** [any but the audio thread] */
    std::shared_ptr<const PlateSnapshot> snapshot() const;

    LevelMeters& meters();

    /** By how many samples the velocities lag the voltages. [any] */
    std::int64_t latencySamples() const;

    /** The latency and 60 dB of the slowest mode's decay, s. [any] */
    double tailSeconds() const;

private:
    std::shared_ptr<SessionOwner<SurfaceSettings>> owner;
    std::shared_ptr<PlateWorker> worker;
    BackgroundThread thread;
};
} // namespace antinode
