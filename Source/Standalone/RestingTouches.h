#pragma once

#include <antinode_base/WordList.h>
#include <antinode_fingers/Finger.h>
#include <antinode_model/Surface.h>
#include <antinode_touch/Touch.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** What TUIO cursors do, for files and options: play foci, or rest as a kind of finger. */
inline constexpr WordList<std::string_view, 4> cursorWords {
    { { "foci", "" }, { "light", "light" }, { "medium", "medium" }, { "firm", "firm" } }
};

/** Touches that rest on the surface as fingers. Each change of fingers is another path of what plays, so that they are
    put down together and not too often. Docs/Decisions/0079-touches-as-fingers.md */
class RestingTouches
{
public:
    using Time = std::chrono::steady_clock::time_point;
    static constexpr std::size_t mostFingers = 10;
    static constexpr auto pause = std::chrono::milliseconds (500); ///< Between two changes, at least.

    /** What touches are, a kind of finger; empty: nothing rests. All that rest are lifted. [any but the audio thread]
     */
    void setKind (const std::string& kind);

    /** A touch that rests, moves or leaves. @param x, y  m @return  whether it was taken: not without a kind, outside
        the surface, or where it would overlap another one [any but the audio thread] */
    bool rest (std::int64_t finger, double x, double y, const Surface&);
    void lift (std::int64_t finger);

    std::size_t count() const;

    /** What is to rest on the surface if that is something else than now, and the pause is over: the fingers that are
        there but for earlier touches, then the touches that overlap none of them. No design knows of touches.
        @param present  the fingers that rest now [message thread] */
    std::optional<std::vector<Finger>> due (const std::vector<Finger>& present, Time now);

    /** The same with all touches lifted, at once. [message thread] */
    std::optional<std::vector<Finger>> allLifted (const std::vector<Finger>& present);

private:
    std::vector<Finger> withoutTouches (const std::vector<Finger>& present) const;

    mutable std::mutex mutex; ///< For the kind and what rests.
    std::string kind;
    std::map<std::int64_t, Finger> resting;
    std::vector<Finger> putDown; ///< On the surface, of the message thread.
    Time last {};
};
} // namespace antinode
