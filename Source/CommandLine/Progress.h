#pragma once

#include <chrono>
#include <string>

namespace antinode
{
/** A line of progress on a terminal, for work that takes more than a second. Silent elsewhere. */
class Progress
{
public:
    /** @param isQuiet  never shows anything */
    explicit Progress (bool isQuiet);

    /** Wipes its line. */
    ~Progress();
    Progress (const Progress&) = delete;
    Progress& operator= (const Progress&) = delete;

    /** @param what   what is being done
        @param share  0 to 1 of it
        [worker] */
    void show (const std::string& what, double share);

private:
    bool isOn;
    bool hasShown = false;
    std::chrono::steady_clock::time_point start, last;
};
} // namespace antinode
