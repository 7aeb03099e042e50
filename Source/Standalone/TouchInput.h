#pragma once

#include "RestingTouches.h"

#include <antinode_model/Surface.h>
#include <antinode_session/Session.h>
#include <antinode_touch/TouchReceiver.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

namespace antinode
{
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
    std::unique_ptr<TouchReceiver> receiver;
};
} // namespace antinode
