#include "PlateCharts.h"

#include "FieldSampling.h"
#include "FocusCharts.h"

#include <antinode_base/Prefixes.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double still = 1e-4;                                    // of the peak: what moves less has no nodal lines
constexpr int mapCells = 220;                                     // along the longer side
constexpr int sectionPlaces = 401;                                // of a cross section
constexpr double besideMap = 125, besideRow = 45, aroundAll = 45; // pixels: what axes, titles and the colour bar take
constexpr long lowestFigure = 240, highestFigure = 1400;          // pixels

/** A map in m/s as a chart in mm/s. */
HeatMap velocityMap (const ModalModel& model, const Eigen::MatrixXd& velocities, const std::vector<Target>& targets)
{
    const auto& surface = model.surface;
    HeatMap chart;
    chart.values = velocities * milli;
    chart.x = { surface.xMinimum * milli, surface.xMaximum * milli };
    chart.y = { surface.yMinimum * milli, surface.yMaximum * milli };
    chart.scale = ColourScale::diverging;
    chart.equalAspect = true;
    chart.surface = surfaceShape (surface);
    chart.rectangles = ceramicRectangles (model);

    for (const auto& target : targets)
        chart.points.push_back ({ target.x * milli, target.y * milli, {} });

    return chart;
}

MapContours halfPeakContour (const Eigen::MatrixXd& values)
{
    const auto peak = values.cwiseAbs().maxCoeff();
    return { { 0.5 * peak, -0.5 * peak }, {} };
}
} // namespace

HeatMap plateFieldChart (const ModalModel& model, const Eigen::VectorXd& field, const std::string& label,
                         const std::vector<Target>& targets)
{
    auto chart = velocityMap (model, fieldMaps (model.surface, field, mapCells).front(), targets);
    chart.xLabel = "x (mm)";
    chart.yLabel = "y (mm)";
    chart.valueLabel = label + " (mm/s)";
    chart.contours = halfPeakContour (chart.values);
    chart.contours.nodalLinesFrom = still * chart.values.cwiseAbs().maxCoeff();
    return chart;
}

ChartGrid plateFieldsChart (const ModalModel& model, const FocusDesign& design, const Eigen::VectorXd& reached)
{
    const auto& wanted = design.target.field;
    Eigen::MatrixXd fields (model.points(), 4);
    fields << wanted, design.truncatedField, reached, reached - wanted;
    const auto maps = fieldMaps (model.surface, fields, mapCells);
    const auto peak = fields (pointsOn (model.surface), Eigen::all).leftCols (3).cwiseAbs().maxCoeff() * milli;
    constexpr const char* titles[] = { "wanted", "represented by the controlled modes", "reached",
                                       "difference: reached \xE2\x88\x92 wanted" };

    ChartGrid grid;
    grid.xLabel = "x (mm)";
    grid.yLabel = "y (mm)";
    grid.columns = 2;

    for (std::size_t i = 0; i < maps.size(); ++i)
    {
        auto panel = velocityMap (model, maps[i], design.description.targets);
        const auto isDifference = i + 1 == maps.size();
        panel.title = titles[i];

        // The large picture names them.
        for (auto& rectangle : panel.rectangles)
            rectangle.label.clear();

        panel.valueLabel = "mm/s";
        panel.valueRange = isDifference ? std::nullopt : std::optional (AxisRange { -peak, peak });
        panel.contours = isDifference ? MapContours {} : halfPeakContour (panel.values);
        grid.panels.emplace_back (std::move (panel));
    }

    return grid;
}

LineChart crossSectionChart (const ModalModel& model, const FocusDesign& design, const Eigen::VectorXd& reached,
                             PlateDirection direction)
{
    const auto& surface = model.surface;
    const auto& focus = design.description.targets.front();
    const auto isAlongX = direction == PlateDirection::alongX;
    Eigen::MatrixX2d places = Eigen::RowVector2d (focus.x, focus.y).replicate (sectionPlaces, 1);
    const Eigen::VectorXd along = isAlongX
                                      ? Eigen::VectorXd::LinSpaced (sectionPlaces, surface.xMinimum, surface.xMaximum)
                                      : Eigen::VectorXd::LinSpaced (sectionPlaces, surface.yMinimum, surface.yMaximum);
    places.col (isAlongX ? 0 : 1) = along;
    Eigen::MatrixX3d fields (model.points(), 3);
    fields << design.target.field, design.truncatedField, reached;
    auto chart = profileChart (along, fieldsAt (surface, fields, places));
    chart.xLabel = isAlongX ? "x (mm)" : "y (mm)";
    chart.markers = { { (isAlongX ? focus.x : focus.y) * milli, "focus" } };

    for (const auto& c : model.ceramics)
    {
        if (isAlongX && focus.y >= c.yMinimum && focus.y <= c.yMaximum)
            chart.spans.push_back ({ c.xMinimum * milli, c.xMaximum * milli, c.name });

        if (! isAlongX && focus.x >= c.xMinimum && focus.x <= c.xMaximum)
            chart.spans.push_back ({ c.yMinimum * milli, c.yMaximum * milli, c.name });
    }

    return chart;
}

MapShape shapeOf (const Outline& outline)
{
    constexpr int linesPerArc = 32; // of a quarter of a circle at most
    MapShape shape;

    for (const auto& path : outline.paths)
    {
        auto& line = shape.emplace_back();

        for (const auto& piece : path)
        {
            const auto count = piece.isStraight ? 1 : linesPerArc;

            for (int i = 0; i < count; ++i)
                line.push_back (milli * piece.at (piece.from + (piece.to - piece.from) * i / count));
        }
    }

    return shape;
}

MapShape surfaceShape (const Surface& surface)
{
    return surface.boundary ? shapeOf (surface.boundary->outline) : MapShape {};
}

std::vector<MapRectangle> ceramicRectangles (const ModalModel& model)
{
    std::vector<MapRectangle> rectangles;

    for (const auto& ceramic : model.ceramics)
        rectangles.push_back ({ ceramic.xMinimum * milli, ceramic.xMaximum * milli, ceramic.yMinimum * milli,
                                ceramic.yMaximum * milli, ceramic.name, shapeOf (ceramic.outline) });

    return rectangles;
}

int plateFigureHeight (const Surface& surface, int width, int columns, int rows)
{
    const auto aspect = (surface.yMaximum - surface.yMinimum) / (surface.xMaximum - surface.xMinimum);
    const auto mapWidth = static_cast<double> (width) / columns - besideMap;
    const auto height = std::lround (rows * (mapWidth * aspect + besideRow) + aroundAll);
    return static_cast<int> (std::clamp (height, lowestFigure, highestFigure));
}
} // namespace antinode
