#include <antinode_text/NaturalOrder.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("Names that differ in numbers are sorted by them, others stay as they are")
{
    using Names = std::vector<std::string>;
    CHECK (inNaturalOrder ({ "FRF_1.csv", "FRF_10.csv", "FRF_2.csv" })
           == Names { "FRF_1.csv", "FRF_2.csv", "FRF_10.csv" });
    CHECK (inNaturalOrder ({ "P10", "P9" }) == Names { "P9", "P10" });
    CHECK (inNaturalOrder ({ "run2/p1_10.wav", "run2/p1_9.wav" }) == Names { "run2/p1_9.wav", "run2/p1_10.wav" });
    CHECK (inNaturalOrder ({ "a2_1", "a10_1", "a2_10", "a2_9" }) == Names { "a2_1", "a2_9", "a2_10", "a10_1" });
    CHECK (inNaturalOrder ({ "2", "-1", "-10" }) == Names { "-10", "-1", "2" });
    CHECK (inNaturalOrder ({ "b", "a1" }) == Names { "b", "a1" });
    CHECK (inNaturalOrder ({}).empty());
    CHECK (orderRemark ({ "d/F1", "d/F10", "d/F2" }, { "d/F1", "d/F2", "d/F10" })
           == "Files are read in the order of the numbers in their names: F1, F2 to F10.");
    CHECK (orderRemark ({ "a" }, { "a" }).empty());
}
