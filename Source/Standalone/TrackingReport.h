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

    /** "drift +0.42 %, following", as of the last call; empty where nothing is tracked. [any] */
    std::string summary() const;

private:
    TrackingState state = TrackingState::off;
    std::string reason;
    std::optional<double> drift; ///< None: no window was heard yet.
};
} // namespace antinode
