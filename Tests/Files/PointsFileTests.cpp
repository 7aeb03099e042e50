#include <antinode_files/OutputFolder.h>
#include <antinode_files/PointsFile.h>

#include <Support/ErrorText.h>
#include <Support/TemporaryFolder.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("Points are measured in the order of the file, or of their numbers")
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "points.csv";
    writeWholeFile (file, "x_mm,y_mm\n10,20\n-3.5,40\n7,8\n");
    const auto points = readPointsFile (file);
    REQUIRE (points.rows() == 3);
    CHECK (points.row (0).isApprox (Eigen::RowVector2d (0.010, 0.020)));
    CHECK (points.row (1).isApprox (Eigen::RowVector2d (-0.0035, 0.040)));
    CHECK (points.row (2).isApprox (Eigen::RowVector2d (0.007, 0.008)));

    writeWholeFile (file, "number,x_mm,y_mm\n10,10,20\n9,9,8\n");
    CHECK (readPointsFile (file).row (0).isApprox (Eigen::RowVector2d (0.009, 0.008)));
}

TEST_CASE ("A file of points that cannot be read says why")
{
    const TemporaryFolder folder;
    CHECK_THAT (errorText ([&] { readPointsFile (folder.path() / "none.csv"); }),
                Catch::Contains ("missing or no plain file"));
    CHECK_THAT (errorText ([&] { readPointsFile (folder.path()); }), Catch::Contains ("missing or no plain file"));
    writeWholeFile (folder.path() / "words.csv", "x,y\na,b\n");
    CHECK_FALSE (errorText ([&] { readPointsFile (folder.path() / "words.csv"); }).empty());
}
