#include <antinode_reports/CurveDrawing.h>
#include <antinode_reports/MapDrawing.h>
#include <antinode_reports/PlotFrame.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace antinode;

namespace
{
CurvePiece noisyCurve (int count, float width)
{
    CurvePiece points;
    for (int k = 0; k < count; ++k)
        points.emplace_back (width * static_cast<float> (k) / static_cast<float> (count),
                             static_cast<float> (std::sin (k * 12.9898) * 40));
    return points;
}
} // namespace

TEST_CASE ("Summing up columns of pixels keeps every extreme of 20 000 samples")
{
    auto points = noisyCurve (20000, 800);
    points[12345].y = 977;
    points[777].y = -655;
    const auto columns = summariseColumns (points, 1);
    REQUIRE (columns.size() == 800);
    const auto isCovered = [&] (juce::Point<float> point)
    {
        const auto& column = columns[static_cast<std::size_t> (point.x)];
        return column.top <= point.y && point.y <= column.bottom;
    };
    CHECK (std::all_of (points.begin(), points.end(), isCovered));
    const auto deepest =
        std::max_element (columns.begin(), columns.end(), [] (auto a, auto b) { return a.bottom < b.bottom; });
    CHECK (deepest->bottom == 977);
    CHECK (columns[777 * 800 / 20000].top == -655);
}

TEST_CASE ("A column also covers the step from the column before, so that a steep curve has no holes")
{
    const auto columns = summariseColumns ({ { 0, 10 }, { 1, 500 }, { 2, -30 } }, 1);
    REQUIRE (columns.size() == 3);
    CHECK (columns[1].top == 10);
    CHECK (columns[1].bottom == 500);
    CHECK (columns[2].top == -30);
    CHECK (columns[2].bottom == 500);
}

TEST_CASE ("A curve that is dense at one end only is a thin line at the other")
{
    CurvePiece points { { 0, 90 } };
    for (int k = 0; k < 4000; ++k)
        points.emplace_back (100 + 0.025f * static_cast<float> (k), 10);
    juce::Image image (juce::Image::RGB, 200, 100, true, juce::SoftwareImageType());
    {
        juce::Graphics g (image);
        drawCurve (g, points, { juce::Colours::white, 2, LineStyle::solid });
    }
    for (int x = 10; x < 90; x += 20)
    {
        auto lit = 0;
        for (int y = 0; y < 100; ++y)
            lit += image.getPixelAt (x, y) != juce::Colours::black ? 1 : 0;
        CHECK (lit >= 2);
        CHECK (lit <= 5);
    }
}

TEST_CASE ("A value that is not finite splits a curve")
{
    const auto gap = std::nanf ("");
    const auto pieces = splitAtGaps ({ { 0, gap }, { 1, 1 }, { 2, 2 }, { 3, gap }, { gap, 4 }, { 5, 5 } });
    REQUIRE (pieces.size() == 2);
    CHECK (pieces[0].size() == 2);
    CHECK (pieces[1].size() == 1);
    CHECK (splitAtGaps ({}).empty());
}

TEST_CASE ("An axis places values from 0 to 1 and bounds what lies far outside")
{
    const ChartAxis linear { "", { -10, 30 }, false, {}, true };
    CHECK (linear.fraction (0) == Approx (0.25));
    CHECK (linear.fraction (1e300) == Approx (21));
    CHECK (std::isnan (linear.fraction (std::nan (""))));
    CHECK (std::isnan (linear.fraction (INFINITY)));
    const ChartAxis logarithmic { "", { 1e-3, 10 }, true, {}, true };
    CHECK (logarithmic.fraction (0.1) == Approx (0.5));
    CHECK (std::isnan (logarithmic.fraction (0)));
    CHECK (std::isnan (logarithmic.fraction (-1)));
}

TEST_CASE ("A plot leaves its labels room inside the area, and equal aspect makes units equally long")
{
    const ChartAxis x { "place (mm)", { 0, 200 }, false, {}, true };
    const ChartAxis y { "height (mm)", { 0, 100 }, false, {}, true };
    const juce::Rectangle<float> area (0, 0, 900, 360);
    const auto frame = layOutPlot (area, x, y, { 20, 80 }, Theme::light());
    CHECK (area.contains (frame.plot));
    CHECK (frame.plot.getX() > 30);
    CHECK (frame.plot.getRight() <= 820);
    CHECK (frame.plot.getY() >= 20);
    const auto equal = withEqualAspect (frame);
    CHECK (equal.plot.getWidth() / equal.plot.getHeight() == Approx (2).epsilon (0.01));
    CHECK (frame.plot.contains (equal.plot));
}

TEST_CASE ("A matrix brought to pixels keeps its values, interpolates between them and averages what is finer")
{
    const Eigen::MatrixXd square = (Eigen::Matrix2d() << 1, 2, 3, 4).finished();
    CHECK (resampled (square, 2, 2) == square);
    const auto larger = resampled (square, 20, 20);
    CHECK (larger (0, 0) == 1);
    CHECK (larger (19, 19) == 4);
    CHECK (larger.mean() == Approx (2.5));
    const Eigen::MatrixXd fine = Eigen::MatrixXd::Random (64, 48);
    const auto coarse = resampled (fine, 16, 12);
    CHECK (coarse (3, 5) == Approx (fine.block (12, 20, 4, 4).mean()));
    const Eigen::MatrixXd single = Eigen::MatrixXd::Constant (1, 1, 7);
    CHECK (resampled (single, 3, 4) == Eigen::MatrixXd::Constant (3, 4, 7));
}
