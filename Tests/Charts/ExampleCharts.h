#pragma once

#include <antinode_reports/Chart.h>
#include <antinode_reports/ChartFile.h>
#include <antinode_reports/Theme.h>

#include <juce_graphics/juce_graphics.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

/** One small chart of each kind with all its parts, and what tests ask of pictures. */
namespace antinode::example_charts
{
inline Eigen::MatrixXd waves (Eigen::Index rows, Eigen::Index columns)
{
    return Eigen::MatrixXd::NullaryExpr (
        rows, columns,
        [] (Eigen::Index row, Eigen::Index column)
        { return std::sin (0.7 * static_cast<double> (row) + 0.31 * static_cast<double> (column)); });
}

inline LineChart lines()
{
    LineChart chart;
    chart.title = "Velocity";
    chart.xLabel = "time (ms)";
    chart.yLabel = "velocity (mm/s)";
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced (400, 0, 25);
    chart.series = { { "reached", x, x.array().sin().matrix() * 40, LineStyle::solid, true },
                     { "wanted", x, x.array().cos().matrix() * 40, LineStyle::dashed } };
    chart.limits = { { 45, "45 mm/s" } };
    chart.markers = { { 20, "focus" }, { 20.1, "next" } };
    chart.spans = { { 3, 8, "C1" } };
    return chart;
}

inline BarChart bars()
{
    BarChart chart;
    chart.title = "Modal spectrum";
    chart.categories = { "1", "2", "3" };
    chart.series = { { "wanted", Eigen::Vector3d (1, -2, 3) }, { "reached", Eigen::Vector3d (1.1, -2, 2.9) } };
    return chart;
}

inline HeatMap map()
{
    HeatMap chart;
    chart.title = "Field";
    chart.values = waves (12, 20);
    chart.scale = ColourScale::diverging;
    chart.equalAspect = true;
    chart.x = { 0, 200 };
    chart.y = { 0, 120 };
    chart.rectangles = { { 10, 60, 15, 40, "C1" } };
    chart.points = { { 120, 70, "focus" } };
    chart.contours = { { -0.5, 0.5 }, 1e-4 };
    return chart;
}

inline HeatMap table()
{
    HeatMap chart;
    chart.title = "Participation";
    chart.values = waves (2, 3);
    chart.columnNames = { "1", "2", "3" };
    chart.rowNames = { "C1", "C2" };
    return chart;
}

inline HeatMap bareMap()
{
    auto chart = map();
    chart.isBare = true;
    return chart;
}

inline PlanView plan()
{
    PlanView chart;
    chart.title = "Device";
    chart.xLabel = "x (mm)";
    chart.yLabel = "y (mm)";
    chart.x = { 0, 200 };
    chart.y = { 0, 120 };
    chart.rectangles = { { 10, 60, 15, 40, "C1" } };
    chart.points = { { 120, 70, "focus" } };
    return chart;
}

inline StackedTraces traces()
{
    StackedTraces chart;
    chart.title = "Voltages";
    chart.unit = "V";
    chart.names = { "C1", "C2" };
    chart.step = 0.01;
    chart.values = 40 * waves (2, 2500);
    chart.limits = Eigen::Vector2d (50, 50);
    chart.markers = { { 20, "focus" } };
    return chart;
}

inline ChartGrid grid()
{
    ChartGrid chart;
    chart.title = "Fields";
    chart.columns = 2;
    chart.panels = { lines(), bars(), map(), traces() };
    chart.columnTitles = { "left", "right" };
    chart.rowTitles = { "above", "below" };
    return chart;
}

inline std::vector<Chart> everyKind()
{
    return { lines(), bars(), map(), table(), bareMap(), traces(), plan(), grid() };
}

inline juce::Image decoded (const std::string& png)
{
    juce::MemoryInputStream stream (png.data(), png.size(), false);
    return juce::PNGImageFormat().decodeImage (stream);
}

inline int pixelsUnlike (const juce::Image& image, juce::Colour background)
{
    auto count = 0;
    for (int y = 0; y < image.getHeight(); ++y)
        for (int x = 0; x < image.getWidth(); ++x)
            count += image.getPixelAt (x, y) != background ? 1 : 0;
    return count;
}

inline std::string toPng (const Chart& chart, const Theme& theme = Theme::light())
{
    return renderPng (chart, 450, 300, 1, theme);
}

inline std::vector<std::string> toPngs (const std::vector<Chart>& charts)
{
    std::vector<std::string> pictures (charts.size());
    std::transform (charts.begin(), charts.end(), pictures.begin(), [] (const Chart& chart) { return toPng (chart); });
    return pictures;
}
} // namespace antinode::example_charts
