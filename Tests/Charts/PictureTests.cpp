#include "ExampleCharts.h"

#include <antinode_reports/Drawing.h>
#include <antinode_reports/Lettering.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <future>
#include <set>

using namespace antinode;
using namespace antinode::example_charts;

TEST_CASE ("A picture has the size asked for times its scale, on the theme's background")
{
    const auto image = decoded (renderPng (lines(), 450, 180, 1.5f, Theme::dark()));
    REQUIRE (image.isValid());
    CHECK (image.getWidth() == 675);
    CHECK (image.getHeight() == 270);
    CHECK (image.getPixelAt (0, 0) == Theme::dark().background);
    CHECK (image.getPixelAt (674, 269) == Theme::dark().background);
}

TEST_CASE ("The last row and column of a picture are background, also where the chart covers them in part")
{
    constexpr int rounding = 1; // of 255, when JUCE blends a colour with itself
    const auto background = Theme::dark().background;
    const auto colourDifference = [] (juce::Colour one, juce::Colour other)
    {
        return std::max ({ std::abs (one.getRed() - other.getRed()), std::abs (one.getGreen() - other.getGreen()),
                           std::abs (one.getBlue() - other.getBlue()) });
    };

    for (const auto scale : { 1.43f, 1.44f, 1.49f })
    {
        const auto image = decoded (renderPng (lines(), 451, 181, scale, Theme::dark()));
        const auto right = image.getWidth() - 1, bottom = image.getHeight() - 1;
        INFO (scale);

        for (int x = 0; x <= right; ++x)
            REQUIRE (colourDifference (image.getPixelAt (x, bottom), background) <= rounding);

        for (int y = 0; y <= bottom; ++y)
            REQUIRE (colourDifference (image.getPixelAt (right, y), background) <= rounding);
    }
}

TEST_CASE ("A picture's bytes are the same each time it is drawn, whatever was drawn in between")
{
    const auto first = toPngs (everyKind());
    auto reversed = everyKind();
    std::reverse (reversed.begin(), reversed.end());
    auto second = toPngs (reversed);
    std::reverse (second.begin(), second.end());
    CHECK (second == first);
}

TEST_CASE ("Threads that draw at the same time draw the same pictures")
{
    auto one = std::async (std::launch::async, toPngs, everyKind());
    auto other = std::async (std::launch::async, toPngs, everyKind());
    const auto expected = toPngs (everyKind());
    CHECK (one.get() == expected);
    CHECK (other.get() == expected);
}

TEST_CASE ("Titles, labels and legends leave glyphs in the picture")
{
    const auto change = [] (auto alter)
    {
        auto chart = lines();
        alter (chart);
        return toPng (chart) != toPng (lines());
    };
    CHECK (change ([] (LineChart& chart) { chart.title = "Velocitx"; }));
    CHECK (change ([] (LineChart& chart) { chart.yLabel = "velocity (m/s)"; }));
    CHECK (change ([] (LineChart& chart) { chart.series[0].name = "achieved"; }));
    CHECK (change ([] (LineChart& chart) { chart.markers[0].label = "t_f"; }));
    CHECK (change ([] (LineChart& chart) { chart.limits[0].label = "limit"; }));
    CHECK (change ([] (LineChart& chart) { chart.spans[0].label = "C2"; }));
}

TEST_CASE ("The compiled-in font has what the charts write: digits, units, Greek, minus, powers")
{
    const TextStyle style { 20, false, juce::Colours::black };
    for (const auto* text : { "0", "V", "\u2212", "×", "⁻", "⁶", "±", "√", "…", "φ", "ω", "\u2013", "é" })
    {
        juce::Image image (juce::Image::RGB, 40, 30, false, juce::SoftwareImageType());
        image.clear (image.getBounds(), juce::Colours::white);
        juce::Graphics g (image);
        drawText (g, text, { 0, 0, 40, 30 }, juce::Justification::centred, style);
        INFO (text);
        CHECK (pixelsUnlike (image, juce::Colours::white) > 4);
        CHECK (textWidth (text, style) > 3);
    }
}

TEST_CASE ("A text that is too long is shortened to its area")
{
    juce::Image image (juce::Image::RGB, 200, 30, false, juce::SoftwareImageType());
    image.clear (image.getBounds(), juce::Colours::white);
    juce::Graphics g (image);
    drawText (g, "a name that is much longer than its place", { 0, 0, 80, 30 }, juce::Justification::centredLeft,
              { 15, true, juce::Colours::black });
    CHECK (pixelsUnlike (image.getClippedImage ({ 0, 0, 80, 30 }), juce::Colours::white) > 50);
    CHECK (pixelsUnlike (image.getClippedImage ({ 81, 0, 119, 30 }), juce::Colours::white) == 0);
}

TEST_CASE ("A map shows large values in other colours than small ones, the first row at the bottom")
{
    HeatMap chart;
    chart.values = (Eigen::Matrix2d() << 0, 0, 1, 1).finished();
    const auto image = decoded (toPng (chart));
    const auto& map = Theme::light().sequential;
    CHECK (image.getPixelAt (150, 40) == map.at (1));
    CHECK (image.getPixelAt (150, 250) == map.at (0));
}

TEST_CASE ("The cells of a table have one colour each, a map runs from one to the next")
{
    HeatMap chart;
    chart.values = (Eigen::MatrixXd (1, 2) << 0, 1).finished();
    const auto shades = [&]
    {
        const auto image = decoded (toPng (chart));
        std::vector<juce::uint32> colours;
        for (int x = 100; x < 300; ++x)
            colours.push_back (image.getPixelAt (x, 100).getARGB());
        std::sort (colours.begin(), colours.end());
        return std::unique (colours.begin(), colours.end()) - colours.begin();
    };
    CHECK (shades() > 50);
    chart.columnNames = { "one", "other" };
    CHECK (shades() == 2);
}

TEST_CASE ("Contours, and nodal lines where something moves, leave lines on a map")
{
    auto chart = map();
    chart.contours = {};
    const auto plain = toPng (chart);
    chart.contours.nodalLinesFrom = 2;
    CHECK (toPng (chart) == plain);
    chart.contours.nodalLinesFrom = 0.5;
    const auto nodal = toPng (chart);
    CHECK (nodal != plain);
    chart.contours.levels = { 0.5 };
    CHECK (toPng (chart) != nodal);
}

TEST_CASE ("A spectrum of more modes than pixels keeps its colours and its largest bar")
{
    constexpr int modes = 900, largest = 333;
    const auto theme = Theme::dark();
    BarChart chart;
    chart.categories.resize (modes);
    chart.yRange = AxisRange { 0, 10 };
    chart.legend = LegendPlace::none;
    Eigen::VectorXd wanted = Eigen::VectorXd::Ones (modes), reached = wanted;
    wanted[largest] = 8;
    reached[largest] = 6;
    chart.series = { { "wanted", wanted, 1 }, { "reached", reached, 0 } };
    const auto image = decoded (renderPng (chart, 450, 300, 1, theme));
    const auto ofWanted = seriesColour (theme, 1, 0), ofReached = seriesColour (theme, 0, 1);
    std::set<int> wantedColumns;
    auto pixelsOfReached = 0;

    for (int x = 0; x < image.getWidth(); ++x)
        for (int y = 0; y < image.getHeight() / 2; ++y)
            if (image.getPixelAt (x, y) == ofWanted)
                wantedColumns.insert (x);
            else
                pixelsOfReached += image.getPixelAt (x, y) == ofReached ? 1 : 0;

    CHECK (wantedColumns.size() == 1);
    CHECK (pixelsOfReached > 10);
}
