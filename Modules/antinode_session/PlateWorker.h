#pragma once

#include "DeviceRounds.h"
#include "PathExchange.h"
#include "PlateSession.h"

#include <atomic>
#include <memory>

namespace antinode
{
/** What a plate session and its thread share: requests and answers under a lock, the work of the thread, and the path
   that the audio thread moves. It lasts as long as the longer of both. The functions are PlateSession's. */
class PlateWorker : public DeviceRounds<PlateSnapshot, SurfaceSettings, double>
{
public:
    PlateWorker (std::shared_ptr<const DeviceDocument>, std::shared_ptr<Owner>);

    void prepare (double sampleRate);
    template <typename Sample>
    void process (const SurfaceBlock<Sample>&, const SurfaceControls&);
    LevelMeters& meters() { return levels; }
    std::int64_t latencySamples() const { return latency; }
    double tailSeconds() const { return tail; }

    /** Works until it is stopped; then no path is left. Nothing may be processing by then. [session's thread] */
    void run();

private:
    void step();
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
