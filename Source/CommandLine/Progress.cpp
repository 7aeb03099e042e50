#include "Progress.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Processes.h>

#include <cmath>
#include <cstdio>
#include <utility>

namespace antinode
{
using namespace std::chrono_literals;

Progress::Progress (bool isQuiet)
    : isOn (! isQuiet && errorsGoToTerminal()), start (std::chrono::steady_clock::now()), last (start)
{
}

Progress::~Progress()
{
    if (hasShown)
        std::fputs ("\r\033[K", stderr);
}

void Progress::show (const std::string& what, double share, const std::string& detail)
{
    if (std::exchange (current, what) != what)
        left = TimeLeft (share);

    const auto now = std::chrono::steady_clock::now();

    if (! isOn || now - start < 1s || now - last < 100ms)
        return;

    auto line = formatted ("%s %3ld %%", what.c_str(), std::lround (100 * share));

    for (const auto& more : { detail, left.at (share) })
        if (! more.empty())
            line += ", " + more;

    std::fprintf (stderr, "\r\033[K%s", line.c_str());
    std::fflush (stderr);
    hasShown = true;
    last = now;
}
} // namespace antinode
