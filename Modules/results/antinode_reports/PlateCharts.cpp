#include "PlateCharts.h"

#include "FocusCharts.h"

#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <antinode_model/ShapeInterpolation.h>

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

namespace
{
constexpr int maximumScatteredCells = 64;

/** The middles of equal cells. */
Eigen::VectorXd middles (double minimum, double maximum, Eigen::Index cells)
{
    const auto half = 0.5 * (maximum - minimum) / static_cast<double> (cells);
    return Eigen::VectorXd::LinSpaced (cells, minimum + half, maximum - half);
}

std::vector<Eigen::MatrixXd> mapsOfGrid (const PlateGrid& grid, const Eigen::MatrixXd& fields, const Eigen::VectorXd& x,
                                         const Eigen::VectorXd& y)
{
    const auto rowsX = interpolationRows (grid.x, x), rowsY = interpolationRows (grid.y, y);
    std::vector<Eigen::MatrixXd> maps;

    for (const auto& field : fields.colwise())
    {
        checkWatch();
        const Eigen::VectorXd values = field;
        const Eigen::Map<const Eigen::MatrixXd> onGrid (values.data(), rowsX.cols(), rowsY.cols());
        maps.emplace_back (rowsY * (rowsX * onGrid).transpose());
    }

    return maps;
}

/** Fields at places, wherever these lie. */
Eigen::MatrixXd valuesAt (const Surface& surface, const Eigen::MatrixXd& fields, const Eigen::MatrixX2d& places)
{
    Eigen::MatrixXd values (places.rows(), fields.cols());

    for (Eigen::Index i = 0; i < places.rows(); ++i)
    {
        checkWatch();
        values.row (i) = surface.grid ? interpolateOnGrid (*surface.grid, fields, places (i, 0), places (i, 1))
                                      : interpolateInPlane (surface.points, fields, places (i, 0), places (i, 1));
    }

    return values;
}

std::vector<Eigen::MatrixXd> mapsOfPoints (const Surface& surface, const Eigen::MatrixXd& fields,
                                           const Eigen::VectorXd& x, const Eigen::VectorXd& y)
{
    Eigen::MatrixX2d places (x.size() * y.size(), 2);
    places.col (0) = x.replicate (y.size(), 1);
    places.col (1) = y.transpose().replicate (x.size(), 1).reshaped();
    const auto values = valuesAt (surface, fields, places);
    std::vector<Eigen::MatrixXd> maps;

    for (const auto& map : values.colwise())
        maps.emplace_back (map.reshaped (x.size(), y.size()).transpose());

    return maps;
}

/** Beyond a boundary maps get the values of its nearest places, so that nothing shows where they are cut off there. */
void continueBeyond (std::vector<Eigen::MatrixXd>& maps, const Surface& surface, const Eigen::MatrixXd& fields,
                     const Eigen::VectorXd& x, const Eigen::VectorXd& y)
{
    std::vector<Eigen::Vector2i> cells;
    std::vector<Eigen::Vector2d> nearest;

    for (Eigen::Index j = 0; j < y.size(); ++j)
        for (Eigen::Index i = 0; i < x.size(); ++i)
            if (! surface.boundary->outline.contains (x[i], y[j]))
            {
                cells.emplace_back (static_cast<int> (j), static_cast<int> (i));
                nearest.push_back (nearestOn (surface, x[i], y[j]));
            }

    Eigen::MatrixX2d places (static_cast<Eigen::Index> (nearest.size()), 2);

    for (std::size_t p = 0; p < nearest.size(); ++p)
        places.row (static_cast<Eigen::Index> (p)) = nearest[p].transpose();

    const auto values = valuesAt (surface, fields, places);

    for (std::size_t p = 0; p < cells.size(); ++p)
        for (std::size_t k = 0; k < maps.size(); ++k)
            maps[k](cells[p][0], cells[p][1]) = values (static_cast<Eigen::Index> (p), static_cast<Eigen::Index> (k));
}
} // namespace

Eigen::MatrixXd fieldsAt (const Surface& surface, const Eigen::MatrixXd& fields, const Eigen::MatrixX2d& places)
{
    auto values = valuesAt (surface, fields, places);

    for (Eigen::Index i = 0; surface.boundary && i < places.rows(); ++i)
        if (! liesOn (surface, places (i, 0), places (i, 1)))
            values.row (i).setConstant (std::nan (""));

    return values;
}

std::vector<Eigen::MatrixXd> fieldMaps (const Surface& surface, const Eigen::MatrixXd& fields, int maximumCells)
{
    const auto width = surface.xMaximum - surface.xMinimum, height = surface.yMaximum - surface.yMinimum;
    const auto cells = surface.grid ? maximumCells : std::min (maximumCells, maximumScatteredCells);
    const auto along = [&] (double length)
    { return std::max<Eigen::Index> (1, std::lround (cells * length / std::max (width, height))); };
    const auto x = middles (surface.xMinimum, surface.xMaximum, along (width));
    const auto y = middles (surface.yMinimum, surface.yMaximum, along (height));
    auto maps = surface.grid ? mapsOfGrid (*surface.grid, fields, x, y) : mapsOfPoints (surface, fields, x, y);

    if (surface.boundary)
        continueBeyond (maps, surface, fields, x, y);

    return maps;
}
} // namespace antinode
