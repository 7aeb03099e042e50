#include <antinode_model/Surface.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("Cells of a plate are about square and fill its extent", "[model]")
{
    Surface plate;
    plate.kind = SurfaceKind::plate;
    plate.xMinimum = -0.105;
    plate.xMaximum = 0.105;
    plate.yMinimum = -0.074;
    plate.yMaximum = 0.074;
    const auto cells = squareCells (plate, 2000);
    CHECK (cells.columns == 53);
    CHECK (cells.rows == 38);
    REQUIRE (cells.centres.rows() == 53 * 38);
    CHECK (0.21 / 53 == Approx (0.148 / 38).epsilon (0.02));
    CHECK (cells.centres (0, 0) == Approx (-0.105 + 0.21 / 106));
    CHECK (cells.centres (1, 0) == Approx (-0.105 + 3 * 0.21 / 106));
    CHECK (cells.centres (53, 1) == Approx (-0.074 + 3 * 0.148 / 76));
    CHECK (cells.centres.colwise().sum().norm() < 1e-12);
}

TEST_CASE ("Cells of a line are one row of as many as asked for", "[model]")
{
    Surface line;
    line.xMinimum = 0;
    line.xMaximum = 0.1;
    const auto cells = squareCells (line, 5);
    CHECK (cells.columns == 5);
    CHECK (cells.rows == 1);
    CHECK (cells.centres (4, 0) == Approx (0.09));
    CHECK (cells.centres.col (1).isZero (0));
}
