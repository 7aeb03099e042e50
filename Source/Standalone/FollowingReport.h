#pragma once

#include <antinode_session/FollowingStatus.h>

#include <optional>
#include <string>

namespace antinode
{
/** What a program without windows says of a followed drift. */
class FollowingReport
{
public:
    /** What is new since the last call: another state, or a jump; else empty. [any] */
    std::string news (const FollowingStatus&);

    /** Prints what is new with its time. [message thread] */
    void print (const FollowingStatus&, double seconds);

    /** "drift +0.42 %, following", as of the last call; empty where nothing is followed. [any] */
    std::string summary() const;

    /** The same as the end of a line: "; drift +0.42 %, following". [any] */
    std::string ending() const;

private:
    FollowingState state = FollowingState::off;
    std::string reason;
    std::optional<double> drift; ///< None: no window was heard yet.
};
} // namespace antinode
