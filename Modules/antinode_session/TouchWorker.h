#pragma once

#include "DeviceFollowing.h"
#include "DeviceRounds.h"
#include "FingerMovement.h"
#include "PathExchange.h"
#include "StopCount.h"
#include "TouchFoci.h"
#include "TouchSession.h"

#include <antinode_felt/SkinThreshold.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace antinode
{
/** What the host plays: a path is for one of these. */
struct TouchFormat
{
    double sampleRate = 0; ///< Hz; 0 before the first preparation.
    int inputs = 0;

    bool operator== (const TouchFormat&) const = default;
};

/** What a touch session and its thread share: requests and answers under a lock, the work of the thread, and the path
   that the audio thread plays. It lasts as long as the longer of both. The functions are TouchSession's. */
class TouchWorker : public DeviceRounds<TouchSnapshot, TouchSettings, TouchFormat>
{
public:
    TouchWorker (std::shared_ptr<const DeviceDocument>, std::shared_ptr<Owner>);

    void prepare (double sampleRate, int inputs);
    template <typename Sample>
    void process (const TouchBlock<Sample>&, const TouchControls&);
    void setComparing (bool shouldCompare) { isComparing = shouldCompare; }
    void setAmplifiers (std::vector<double> volts);
    void loadFocus (std::shared_ptr<const FocusDocument> focus) { foci.load (std::move (focus)); }
    std::shared_ptr<const FocusDocument> focus() const { return foci.focus(); }
    DesignProgress focusProgress() const { return foci.progress(); }
    FociUnderFingers fociUnderFingers() const { return foci.underFingers(); }
    void waitUntilSettled (std::span<const FocusEvent> notes);
    StopCount& stops() { return stopCount; }
    LevelMeters& meters() { return levels; }
    FingerMeters& fingerMeters() { return fingerLevels; }
    std::int64_t latencySamples (std::size_t latency) const;
    double tailSeconds (std::size_t latency) const;
    double fullScaleVolts() const { return fullScale; }
    FollowingRequests& following() const { return *followingRequests; }

    /** Works until it is stopped; then no path is left. Nothing may be processing by then. [session's thread] */
    void run();

private:
    TouchSettings look();
    void step();
    void serveFoci();
    void takeAmplifiers();
    void takeFollowing();
    void takeDrift();
    void buildPath();
    void makeDesigner();
    bool isSettled() const;
    void design();
    bool playQuickly();
    bool areFingersResting();
    bool isAwaited() const;
    void makeDesign();
    void play (std::unique_ptr<const FilterBank>, const TouchSettings& places);
    void compare();
    void waitForFoci();
    bool hasOtherPath();
    bool hasNews();

    std::atomic<bool> isComparing { false };
    std::vector<double> wantedAmplifiers;               ///< V, under the lock.
    std::optional<std::vector<int>> awaitedNotes;       ///< Under the lock: somebody waits for their foci.
    std::vector<double> amplifiers;                     ///< Of the session's thread, as the next lines.
    std::shared_ptr<const DeviceDocument> playedDevice; ///< The model's: what was asked for may have no model.
    std::shared_ptr<const ModalModel> solved, limited;  ///< Without and with the amplifiers.
    std::optional<TouchSettings> designedFor; ///< Also where that failed: nobody shall try it again and again.
    TouchFormat format;
    SkinThreshold threshold;
    std::shared_ptr<FollowingRequests> followingRequests = std::make_shared<FollowingRequests>();
    DeviceFollowing deviceFollowing { followingRequests };
    std::unique_ptr<TouchDesigner> designer;
    bool isRetuned = false; ///< Whether it is for a device that has drifted since the filters that play were made.
    FingerMovement movement;
    FingerMovement::Clock::duration quickTime = std::chrono::milliseconds (10); ///< That quick filters last took.
    TouchFoci foci;
    double toldEnd = 0;        ///< s, of the foci: the tail that the owner knows.
    bool isPathNew = false;    ///< Whether no focus was asked for it yet.
    TouchPath* path = nullptr; ///< The newest one, which `paths` owns.

    StopCount stopCount;
    std::uint64_t playedStop = 0; ///< Of the audio thread: the newest one.
    PathExchange<TouchPath> paths;
    EventDelay noteDelay; ///< Of the audio thread.
    LevelMeters levels;
    FingerMeters fingerLevels;
    std::atomic<double> preparedRate { 0 }, ringing { 1 }, fullScale { 0 };
    std::atomic<std::int64_t> late { 0 }; ///< Samples by which outputs come later where lags of ceramics are undone.
};
} // namespace antinode
