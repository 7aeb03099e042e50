#include <antinode_base/Progress.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("Time left is that of the same pace, in words", "[base]")
{
    CHECK (timeLeftInWords (10, 0.2) == "about 40 s left");
    CHECK (timeLeftInWords (60, 0.25) == "about 3 min left");
    CHECK (timeLeftInWords (1200, 0.2) == "about 1 h 20 min left");
    CHECK (timeLeftInWords (10, 0.999) == "about 1 s left");
}

TEST_CASE ("Time left is not told before it can be known, nor at the end", "[base]")
{
    CHECK (timeLeftInWords (1.9, 0.5).empty());
    CHECK (timeLeftInWords (100, 0.01).empty());
    CHECK (timeLeftInWords (100, 1).empty());
    CHECK (TimeLeft().at (0.5).empty());
}
