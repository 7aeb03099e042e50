#include "ModeCharts.h"

#include "FieldSampling.h"
#include "Numbers.h"
#include "PlateCharts.h"

#include <antinode_base/Prefixes.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
bool isPlate (const ModalModel& model)
{
    return model.surface.kind == SurfaceKind::plate;
}

namespace
{
constexpr int mapCells = 110;                      // along the longer side of a plate
constexpr int plateColumns = 6, lineColumns = 4;   // of the gallery
constexpr int lineHeight = 96, titleAndGap = 26;   // pixels, of one panel
constexpr double lowestMap = 40, highestMap = 300; // pixels
constexpr AxisRange scaledRange { -1, 1 };

Eigen::Index shownModes (const ModalModel& model, int count)
{
    return std::min<Eigen::Index> (count, model.modes());
}

std::string modeTitle (const ModalModel& model, Eigen::Index mode)
{
    const auto frequency = model.frequencyHz (mode);
    return std::to_string (mode + 1) + ": " + formatFixed (frequency, frequency < 100 ? 1 : 0) + " Hz";
}

AxisRange alongX (const Surface& surface)
{
    return { surface.xMinimum * milli, surface.xMaximum * milli };
}

Eigen::MatrixXd scaledToOne (const Eigen::MatrixXd& shape)
{
    const auto largest = shape.cwiseAbs().maxCoeff();
    return largest > 0 ? Eigen::MatrixXd (shape / largest) : shape;
}

/** Parts of a boundary as open lines, mm. */
MapShape linesOf (const std::vector<PathPiece>& pieces)
{
    MapShape lines;

    for (const auto& piece : pieces)
    {
        lines.push_back (shapeOf ({ { { piece } } }).front());
        lines.back().push_back (milli * piece.end);
    }

    return lines;
}

std::vector<Panel> plateShapes (const ModalModel& model, Eigen::Index count)
{
    const auto maps = fieldMaps (model.surface, model.shapes.leftCols (count), mapCells);
    std::vector<Panel> panels;

    for (Eigen::Index mode = 0; mode < count; ++mode)
    {
        HeatMap map;
        map.title = modeTitle (model, mode);
        map.values = scaledToOne (maps[static_cast<std::size_t> (mode)]);
        map.x = alongX (model.surface);
        map.y = { model.surface.yMinimum * milli, model.surface.yMaximum * milli };
        map.valueRange = scaledRange;
        map.scale = ColourScale::diverging;
        map.contours.nodalLinesFrom = 1e-6;
        map.surface = surfaceShape (model.surface);
        map.equalAspect = map.isBare = true;
        panels.emplace_back (std::move (map));
    }

    return panels;
}

std::vector<Panel> lineShapes (const ModalModel& model, Eigen::Index count)
{
    std::vector<Panel> panels;

    for (Eigen::Index mode = 0; mode < count; ++mode)
    {
        LineChart chart;
        chart.title = modeTitle (model, mode);
        chart.series = { { {}, model.surface.points.col (0) * milli, scaledToOne (model.shapes.col (mode)) } };
        chart.xRange = alongX (model.surface);
        chart.yRange = AxisRange { 1.08 * scaledRange.minimum, 1.08 * scaledRange.maximum };

        for (const auto& ceramic : model.ceramics)
            chart.spans.push_back ({ ceramic.xMinimum * milli, ceramic.xMaximum * milli, {} });

        panels.emplace_back (std::move (chart));
    }

    return panels;
}
} // namespace

PlanView deviceChart (const ModalModel& model, const std::vector<PathPiece>& elastic)
{
    const auto& surface = model.surface;
    PlanView view;
    view.x = alongX (surface);
    view.rectangles = ceramicRectangles (model);
    const auto isKnown = model.unknowns > 0 && ! surface.boundary; // measured devices do not say
    view.heldLeft = isKnown && surface.held.left;
    view.heldRight = isKnown && surface.held.right;

    if (isPlate (model))
    {
        view.xLabel = "x (mm)";
        view.yLabel = "y (mm)";
        view.y = { surface.yMinimum * milli, surface.yMaximum * milli };
        view.surface = surfaceShape (surface);

        if (surface.boundary)
            view.heldPieces = linesOf (surface.boundary->held);

        view.elasticPieces = linesOf (elastic);
        view.heldBottom = isKnown && surface.held.bottom;
        view.heldTop = isKnown && surface.held.top;
        return view;
    }

    view.xLabel = "position (mm)";
    view.y = scaledRange;

    for (auto& rectangle : view.rectangles)
        rectangle.yMinimum = -(rectangle.yMaximum = 0.6);

    return view;
}

ChartGrid modeGallery (const ModalModel& model, int count)
{
    ChartGrid grid;
    grid.columns = isPlate (model) ? plateColumns : lineColumns;
    grid.panels = isPlate (model) ? plateShapes (model, shownModes (model, count))
                                  : lineShapes (model, shownModes (model, count));
    grid.xLabel = isPlate (model) ? "" : "position (mm)";
    return grid;
}

int comfortableGalleryHeight (const ModalModel& model, int count, int width)
{
    const auto& surface = model.surface;
    const auto columns = isPlate (model) ? plateColumns : lineColumns;
    const auto rows = static_cast<int> ((shownModes (model, count) + columns - 1) / columns);

    if (! isPlate (model))
        return rows * (lineHeight + titleAndGap) + 2 * titleAndGap;

    const auto mapWidth = static_cast<double> (width) / columns - 10;
    const auto height = mapWidth * (surface.yMaximum - surface.yMinimum) / (surface.xMaximum - surface.xMinimum);
    return rows * (static_cast<int> (std::clamp (height, lowestMap, highestMap)) + titleAndGap) + titleAndGap;
}

HeatMap participationChart (const ModalModel& model)
{
    const Eigen::VectorXd largest = model.participation.cwiseAbs().rowwise().maxCoeff();
    HeatMap chart;
    chart.xLabel = "mode";
    chart.yLabel = "ceramic";
    chart.valueLabel = "participation relative to the mode's largest";
    chart.scale = ColourScale::diverging;
    chart.valueRange = scaledRange;
    chart.values = Eigen::MatrixXd::Zero (model.actuators(), model.modes());

    for (Eigen::Index mode = 0; mode < model.modes(); ++mode)
    {
        chart.columnNames.push_back (std::to_string (mode + 1));

        // A mode of which nothing but rounding is left is driven by no ceramic.
        if (largest[mode] > 1e-12 * largest.maxCoeff())
            chart.values.col (mode) = model.participation.row (mode).transpose() / largest[mode];
    }

    for (const auto& ceramic : model.ceramics)
        chart.rowNames.push_back (ceramic.name);

    return chart;
}
} // namespace antinode
