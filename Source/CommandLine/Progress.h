#pragma once

#include <antinode_base/ShowProgress.h>
#include <antinode_base/TimeLeft.h>

#include <chrono>
#include <string>

namespace antinode
{
/** A line of progress with the time left on a terminal, for work that takes more than a second. Silent elsewhere. */
class Progress
{
public:
    /** @param isQuiet  never shows anything */
    explicit Progress (bool isQuiet);

    /** Wipes its line. */
    ~Progress();
    Progress (const Progress&) = delete;
    Progress& operator= (const Progress&) = delete;

    /** Shows what is being done, how much of it, and how long the rest will take.
        @param what    what is being done
        @param share   0 to 1 of it
        @param detail  more words, for example "12 of 46"; may be empty
        [worker] from one thread at a time */
    void show (const std::string& what, double share, const std::string& detail = {});

    /** show() as a function, which must not outlive it. */
    ShowProgress shown()
    {
        return [this] (const std::string& what, double share) { show (what, share); };
    }

private:
    bool isOn;
    bool hasShown = false;
    std::string current;
    TimeLeft left;
    std::chrono::steady_clock::time_point start, last;
};
} // namespace antinode
