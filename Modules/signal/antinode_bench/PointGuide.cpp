#include "PointGuide.h"

#include <antinode_base/Prefixes.h>

#include <cstdio>
#include <iostream>

namespace antinode
{
namespace
{
} // namespace

PointAnswer PointGuide::ask (const Eigen::MatrixX2d& places, Eigen::Index first, Eigen::Index count) const
{
    std::string answer;

    while (! silent)
    {
        for (auto p = first; p < first + count; ++p)
            std::printf ("point %td of %td: %.6g, %.6g mm\n", p + 1, places.rows(), places (p, 0) * milli,
                         places (p, 1) * milli);

        std::printf ("Enter measures, s skips, r repeats the previous point, q ends for now: ");
        std::fflush (stdout);

        if (! std::getline (std::cin, answer) || answer == "q")
            return PointAnswer::end;

        if (answer == "s")
            return PointAnswer::skip;

        if (answer == "r")
            return PointAnswer::again;

        if (answer.empty())
            break;
    }

    return PointAnswer::measure;
}

void PointGuide::tell (const std::string& sentence) const
{
    if (listener)
        return listener (sentence);

    std::printf ("%s\n", sentence.c_str());
    std::fflush (stdout);
}
} // namespace antinode
