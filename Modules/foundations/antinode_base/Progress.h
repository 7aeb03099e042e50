#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace antinode
{
/** Takes what is being done and the share of it that is done, 0 to 1: a line on a terminal, a bar, nothing. Called
    often; must be quick. */
using ShowProgress = std::function<void (const std::string& what, double share)>;

/** A duration as a person would say it: "40 s", "3 min", "1 h 20 min". @param seconds  at least 0 [any] */
std::string durationInWords (double seconds);

/** How long work will go on at the pace of its beginning: "about 40 s left". Empty while that is not known: before 2 s
   and 2 % of it. [any]
    @param elapsed  s so far
    @param share    of the work that is done, 0 to 1 */
std::string timeLeftInWords (double elapsed, double share);

/** The same for work that begins where this is made. */
class TimeLeft
{
public:
    /** @param share  that is done already: its time does not count */
    explicit TimeLeft (double share = 0) : begun (std::chrono::steady_clock::now()), before (share) {}

    /** @param share  of the work that is done, 0 to 1 [any] */
    std::string at (double share) const;

private:
    std::chrono::steady_clock::time_point begun;
    double before;
};
} // namespace antinode
