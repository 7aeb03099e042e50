#pragma once

#include "PathExchange.h"
#include "TouchSession.h"

#include <antinode_felt/SkinThreshold.h>

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>

namespace antinode
{
/** What a touch session and its thread share: requests and answers under a lock, the work of the thread, and the path
   that the audio thread plays. It lasts as long as the longer of both. The functions are TouchSession's. */
class TouchWorker
{
public:
    using Owner = SessionOwner<TouchSettings>;

    TouchWorker (std::shared_ptr<const DeviceDocument>, std::shared_ptr<Owner>);

    void load (std::shared_ptr<const DeviceDocument>);
    void prepare (double sampleRate, int inputs);
    template <typename Sample>
    void process (const TouchBlock<Sample>&, const TouchControls&);
    void waitUntilSettled();
    void setComparing (bool shouldCompare) { isComparing = shouldCompare; }
    std::shared_ptr<const TouchSnapshot> snapshot() const;
    LevelMeters& meters() { return levels; }
    FingerMeters& fingerMeters() { return fingerLevels; }
    std::int64_t latencySamples (std::size_t latency) const;
    double tailSeconds() const { return tail; }

    /** Ends the thread as soon as its work lets it. [any but the audio thread] */
    void stop();

    /** Works until it is stopped; then no path is left. Nothing may be processing by then. [session's thread] */
    void run();

private:
    /** What the host plays: a path is for one of these. */
    struct Format
    {
        double sampleRate = 0; ///< Hz; 0 before the first preparation.
        int inputs = 0;

        bool operator== (const Format&) const = default;
    };

    bool awaitRound (std::uint64_t& round);
    void step();
    bool takeDocument();
    void solve();
    void buildPath();
    bool isSettled() const;
    void design();
    void playQuickly();
    bool areFingersResting();
    void makeDesign();
    void play (std::unique_ptr<const FilterBank>);
    void compare();
    bool hasOtherPath();
    bool hasNews();
    void publish();

    std::shared_ptr<Owner> owner;
    std::atomic<bool> isStopping { false }, isComparing { false };
    mutable std::mutex mutex; ///< For the next lines, and what ends a wait is changed under it.
    std::condition_variable wake, settled;
    std::shared_ptr<const DeviceDocument> nextDevice;
    Format wantedFormat;
    std::uint64_t roundsRequested = 0, roundsDone = 0;
    std::shared_ptr<const TouchSnapshot> published;

    TouchSnapshot present; ///< Of the session's thread, as the next lines.
    TouchSettings settings;
    std::optional<TouchSettings> designedFor; ///< Also where that failed: nobody shall try it again and again.
    Format format;
    SkinThreshold threshold;
    std::unique_ptr<TouchDesigner> designer;
    TouchPath* path = nullptr; ///< The newest one, which `paths` owns.
    bool isModelNew = false;

    PathExchange<TouchPath> paths;
    LevelMeters levels;
    FingerMeters fingerLevels;
    std::atomic<double> preparedRate { 0 }, tail { 1 };
};
} // namespace antinode
