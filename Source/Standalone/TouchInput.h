#pragma once

#include <antinode_model/Surface.h>
#include <antinode_session/Session.h>
#include <antinode_touch/TouchReceiver.h>

#include <memory>
#include <utility>

namespace antinode
{
/** Where a touch lies. Fractions are of the surface's extent, millimetres those of its drawing. @return  x, y in m [any] */
std::pair<double, double> placeOf (const Touch&, const Surface&);

/** Touches from the network as foci of a session. */
class TouchInput
{
public:
    /** @param sessionToPlay  outlives this [message thread] */
    explicit TouchInput (Session& sessionToPlay) : session (sessionToPlay) {}

    /** Closes the ports that are open and opens these. @throws InputError  as TouchReceiver; then none is open [message thread] */
    void open (const TouchPorts&);

    /** Those that are open; 0 where none is. [message thread] */
    TouchPorts ports() const { return receiver != nullptr ? receiver->ports() : TouchPorts { 0, 0, "127.0.0.1" }; }

    /** [message thread] */
    TouchCounters counters() const { return receiver != nullptr ? receiver->counters() : TouchCounters {}; }

private:
    Session& session;
    std::unique_ptr<TouchReceiver> receiver;
};

/** What a touch does to a session. [any but the audio thread] */
void play (const Touch&, Session&);
} // namespace antinode
