#pragma once

#include <antinode_base/Reflection.h>
#include <antinode_fingers/Finger.h>
#include <antinode_model/Surface.h>
#include <antinode_session/Session.h>
#include <antinode_touch/Touch.h>
#include <antinode_touch/TouchReceiver.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace antinode
{
/** What TUIO cursors do, for files and options: play foci, or rest as a kind of finger. */
inline constexpr WordList<std::string_view, 4> cursorWords {
    { { "foci", "" }, { "light", "light" }, { "medium", "medium" }, { "firm", "firm" } }
};

/** What became of a touch that is to rest. */
enum class RestResult
{
    taken,          ///< It rests, or waits for room.
    outsideSurface, ///< Nothing changes.
    noKind          ///< No kind of finger is chosen.
};

/** Touches that rest on the surface as fingers. Each change of fingers is another path of what plays, so that they are
    put down together and not too often. Docs/Design/fingers.md */
class RestingTouches
{
public:
    using Time = std::chrono::steady_clock::time_point;
    static constexpr auto pause = std::chrono::milliseconds (500); ///< Between two changes, at least.
    static constexpr double step = 0.005; ///< Of the surface: a touch that has moved less has not moved.

    /** What touches are, a kind of finger; empty: nothing rests. Forgets all. [any but the audio thread] */
    void setKind (const std::string& kind);

    /** A touch that comes or moves. @param x, y  m [any but the audio thread] */
    RestResult rest (std::int64_t finger, double x, double y, const Surface&);

    /** A touch that leaves, or none of that number. [any but the audio thread] */
    void lift (std::int64_t finger);

    /** Those that rest or wait for room. [any but the audio thread] */
    std::size_t count() const;

    /** The touches that are to be on the surface, if these are others than now and the pause is over. In the order in
        which they came: all that lie on the surface and overlap neither a finger of the focus nor an earlier one, as
        many as the focus has room for. No design knows of them.
        @param own      the fingers of the focus
        @param present  the touches on the surface
        [message thread] */
    std::optional<std::vector<Finger>> due (const std::vector<Finger>& own, const std::vector<Finger>& present,
                                            const Surface&, Time now);

private:
    std::vector<Finger> fitting (std::vector<Finger> own, const Surface&) const;

    mutable std::mutex mutex; ///< For the kind and what rests.
    std::string kind;
    std::vector<std::pair<std::int64_t, Finger>> resting; ///< In the order in which they came.
    Time last {};                                         ///< Of the message thread.
};

/** The position of a touch. Fractions are of the surface's extent, millimetres those of its drawing. @return  x, y in m
    [any] */
std::pair<double, double> touchPlace (const Touch&, const Surface&);

/** Valid touches that do nothing. */
struct UnplayedTouches
{
    std::int64_t outsideSurface = 0;
    std::int64_t notAccepted = 0; ///< No device was solved yet, or too many waited.
    std::int64_t withoutKind = 0; ///< Fingers by `/antinode/finger` while no kind of finger was chosen.
};

/** Touches from the network as foci of a session, and as fingers that rest on its surface. */
class TouchInput
{
public:
    /** @param sessionToPlay  outlives this [message thread] */
    explicit TouchInput (Session& sessionToPlay) : session (sessionToPlay) {}

    /** Closes the ports that are open and opens these. @throws InputError  as TouchReceiver; then none is open [message
        thread] */
    void open (const TouchPorts&);

    /** What takes commands of the ports that are opened from now on. [message thread] */
    void setControl (OscControl controlToUse) { control = std::move (controlToUse); }

    /** Those that are open; 0 where none is. [message thread] */
    TouchPorts ports() const { return receiver != nullptr ? receiver->ports() : TouchPorts { 0, 0, "127.0.0.1" }; }

    /** [message thread] */
    TouchCounters counters() const { return receiver != nullptr ? receiver->counters() : TouchCounters {}; }

    /** Since the ports were opened. [any] */
    UnplayedTouches unplayed() const { return { outsideSurface, notAccepted, withoutKind }; }

    /** Passes a touch to the session, or keeps it as a finger; counts touches that do nothing.
        [any but the audio thread] */
    void play (const Touch&);

    /** The touches that rest. [any] */
    RestingTouches& resting() { return fingers; }
    const RestingTouches& resting() const { return fingers; }

private:
    void place (const Touch&);

    Session& session;
    RestingTouches fingers;
    std::atomic<std::int64_t> outsideSurface { 0 }, notAccepted { 0 }, withoutKind { 0 };
    OscControl control;
    std::unique_ptr<TouchReceiver> receiver;
};
} // namespace antinode
