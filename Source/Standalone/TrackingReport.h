#pragma once

#include <antinode_session/TrackingStatus.h>

#include <optional>
#include <string>

namespace antinode
{
/** What a program without windows says of a tracked drift. */
class TrackingReport
{
public:
    /** What is new since the last call: another state, or a jump; else empty. [any] */
    std::string news (const TrackingStatus&);

    /** Prints what is new with its time. [message thread] */
    void print (const TrackingStatus&, double seconds);

    /** "drift +0.42 %, following", as of the last call; empty where nothing is tracked. [any] */
    std::string summary() const;

    /** The same as the end of a line: "; drift +0.42 %, following". [any] */
    std::string ending() const;

private:
    TrackingState state = TrackingState::off;
    std::string reason;
    std::optional<double> drift; ///< None: no window was heard yet.
};
} // namespace antinode
