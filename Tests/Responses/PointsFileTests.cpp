#include "Support/ErrorText.h"

#include <antinode_responses/PointsFile.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("Points are read in mm, with a heading or none, by any separator")
{
    const auto points = decodePoints ("x_mm,y_mm\n# corner\n10, 20\n\n-3.5;4e1\r\n7\t8", "points.csv");
    REQUIRE (points.rows() == 3);
    CHECK (points.row (0).isApprox (Eigen::RowVector2d (0.010, 0.020)));
    CHECK (points.row (1).isApprox (Eigen::RowVector2d (-0.0035, 0.040)));
    CHECK (points.row (2).isApprox (Eigen::RowVector2d (0.007, 0.008)));
    CHECK (decodePoints ("5\n6", "points.csv").col (1).isZero());
    CHECK (decodePoints ("\xef\xbb\xbf% places\r\"1,5\";-2,5\r", "points.csv") == Eigen::RowVector2d (0.0015, -0.0025));
}

TEST_CASE ("Points that cannot be read name their line")
{
    const auto error = [] (std::string_view text) { return errorText ([&] { decodePoints (text, "points.csv"); }); };
    CHECK (error ("x,y\n1,2\n3,b\n") == "points.csv: line 3: is '3,b'; allowed: x and y in mm, for example 12.5,30");
    CHECK_THAT (error ("1,2\n1e9,2\n"), Catch::Contains ("line 2"));
    CHECK_THAT (error ("1,2\nnan,2\n"), Catch::Contains ("line 2"));
    CHECK_THAT (error ("1,2\n1,2,3\n"), Catch::Contains ("line 2"));
    CHECK_THAT (error ("1,2\n1,\n"), Catch::Contains ("line 2"));
    CHECK (error ("x,y\n") == "points.csv: has no point; allowed: lines of x and y in mm");
}
