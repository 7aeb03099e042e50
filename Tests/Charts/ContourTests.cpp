#include <antinode_reports/MapOverlays.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;

TEST_CASE ("The contour of a cone is one closed circle")
{
    const Eigen::Vector2d centre (20.3, 14.8);
    const Eigen::MatrixXd distances = Eigen::MatrixXd::NullaryExpr (
        31, 41,
        [&] (Eigen::Index row, Eigen::Index column)
        { return (Eigen::Vector2d (static_cast<double> (column), static_cast<double> (row)) - centre).norm(); });
    const auto lines = contourLines (distances, 10);
    REQUIRE (lines.size() == 1);
    CHECK (lines[0].front() == lines[0].back());
    double length = 0;

    for (std::size_t k = 0; k < lines[0].size(); ++k)
    {
        // Linear between values a cell apart where the second derivative is at most 1/r: wrong by at most 1/8r.
        CHECK ((lines[0][k] - centre).norm() == Approx (10).margin (1.0 / 80));
        length += k > 0 ? (lines[0][k] - lines[0][k - 1]).norm() : 0;
    }

    CHECK (length == Approx (20 * 3.141592653589793).epsilon (0.005));
}

TEST_CASE ("The contour of a slope is one straight line from edge to edge")
{
    const Eigen::MatrixXd slope = Eigen::RowVectorXd::LinSpaced (6, 0, 5).replicate (4, 1);
    const auto lines = contourLines (slope, 2.25);
    REQUIRE (lines.size() == 1);
    REQUIRE (lines[0].size() == 4);

    for (std::size_t k = 0; k < 4; ++k)
        CHECK (lines[0][k] == Eigen::Vector2d (2.25, static_cast<double> (k)));
}

TEST_CASE ("At a saddle two lines pass on the side that the mean says")
{
    const auto cutCorner = [] (double diagonal)
    {
        const Eigen::Matrix2d saddle { { diagonal, -1 }, { -1, diagonal } };
        const auto lines = contourLines (saddle, 0);
        REQUIRE (lines.size() == 2);

        // The corners on one side of both lines belong together; the first line starts at the lower edge.
        return lines[0].back();
    };
    CHECK (cutCorner (3).x() == 1);
    CHECK (cutCorner (0.5).x() == 0);
}

TEST_CASE ("Where a value is missing, or nothing crosses the level, there is no line")
{
    Eigen::MatrixXd slope = Eigen::RowVectorXd::LinSpaced (6, 0, 5).replicate (5, 1);
    CHECK (contourLines (slope, 7).empty());
    CHECK (contourLines ({}, 0).empty());
    CHECK (contourLines (Eigen::MatrixXd::Zero (4, 4), 0).empty());
    slope (2, 2) = std::nan ("");
    CHECK (contourLines (slope, 2.5).size() == 2);
}
