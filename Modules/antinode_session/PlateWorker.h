#pragma once

#include "PathExchange.h"
#include "PlateSession.h"

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>

namespace antinode
{
/** What a plate session and its thread share: requests and answers under a lock, the work of the thread, and the path
   that the audio thread moves. It lasts as long as the longer of both. The functions are PlateSession's. */
class PlateWorker
{
public:
    using Owner = SessionOwner<SurfaceSettings>;

    PlateWorker (std::shared_ptr<const DeviceDocument>, std::shared_ptr<Owner>);

    void load (std::shared_ptr<const DeviceDocument>);
    void prepare (double sampleRate);
    template <typename Sample>
    void process (const SurfaceBlock<Sample>&, const SurfaceControls&);
    void waitUntilSettled();
    std::shared_ptr<const PlateSnapshot> snapshot() const;
    LevelMeters& meters() { return levels; }
    std::int64_t latencySamples() const { return latency; }
    double tailSeconds() const { return tail; }

    /** Ends the thread as soon as its work lets it. [any but the audio thread] */
    void stop();

    /** Works until it is stopped; then no path is left. Nothing may be processing by then. [session's thread] */
    void run();

private:
    bool awaitRound (std::uint64_t& round);
    void step();
    bool takeDocument();
    void solve();
    void buildPath (double sampleRate);
    void moveProbes();
    void publish();
    Eigen::MatrixXd probeShapes() const;

    std::shared_ptr<Owner> owner;
    std::atomic<bool> isStopping { false };
    mutable std::mutex mutex; ///< For the next lines, and what ends a wait is changed under it.
    std::condition_variable wake, settled;
    std::shared_ptr<const DeviceDocument> nextDevice;
    double wantedRate = 0; ///< Hz; 0 before the first preparation.
    std::uint64_t roundsRequested = 0, roundsDone = 0;
    std::shared_ptr<const PlateSnapshot> published;

    PlateSnapshot present; ///< Of the session's thread, as the next lines.
    SurfaceSettings settings;
    double rate = 0;
    bool isModelNew = false;
    PlatePath* path = nullptr; ///< The newest one, which `paths` owns.

    PathExchange<PlatePath> paths;
    LevelMeters levels;
    std::atomic<double> preparedRate { 0 }, tail { 1 };
    /** Until a path is there: that of the surface as rendered, the reach of its reconstruction. */
    std::atomic<std::int64_t> latency { 15 };
};
} // namespace antinode
