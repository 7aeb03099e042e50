#include "Progress.h"

#include <cmath>
#include <cstdio>

#include <unistd.h>

namespace antinode
{
using namespace std::chrono_literals;

Progress::Progress (bool isQuiet)
    : isOn (! isQuiet && isatty (STDERR_FILENO) != 0), start (std::chrono::steady_clock::now()), last (start)
{
}

Progress::~Progress()
{
    if (hasShown)
        std::fputs ("\r\033[K", stderr);
}

void Progress::show (const std::string& what, double share)
{
    const auto now = std::chrono::steady_clock::now();

    if (! isOn || now - start < 1s || now - last < 100ms)
        return;

    std::fprintf (stderr, "\r\033[K%s %3ld %%", what.c_str(), std::lround (100 * share));
    std::fflush (stderr);
    hasShown = true;
    last = now;
}
} // namespace antinode
