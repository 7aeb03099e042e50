#include "ModesReport.h"

#include "PlateCharts.h"
#include "Ticks.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_identification/Comparison.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace antinode
{
namespace
{
constexpr int galleryModes = 48;
constexpr int lineDeviceHeight = 140; // pixels
constexpr int matrixRowHeight = 16, aroundMatrix = 110, lowestMatrix = 240, highestMatrix = 900;

ReportSection deviceSection (const ModalModel& model, const std::vector<PathPiece>& elastic)
{
    ReportSection section;
    section.heading = "Device";
    section.figures.push_back (
        { "The surface from above, with the ceramics. Ceramic k is output channel k. Hatched edges are held: clamped "
          "or simply supported."
              + std::string (elastic.empty() ? "" : " Zigzag edges rest on springs."),
          {},
          deviceChart (model, elastic),
          reportFigureWidth,
          isPlate (model) ? plateFigureHeight (model.surface, reportFigureWidth, 1, 1) : lineDeviceHeight });
    return section;
}

ReportSection shapeSection (const ModalModel& model)
{
    const auto shown = std::min<Eigen::Index> (galleryModes, model.modes());
    ReportSection section;
    section.heading = "Mode shapes";
    section.figures.push_back (
        { "The lowest " + std::to_string (shown) + " of " + std::to_string (model.modes())
              + " modes, each scaled to its largest value. "
              + (isPlate (model) ? "Lines are nodal lines, where the plate does not move." : "Ceramics are shaded."),
          {},
          modeGallery (model, galleryModes),
          reportFigureWidth,
          comfortableGalleryHeight (model, galleryModes, reportFigureWidth) });
    return section;
}

ReportSection participationSection (const ModalModel& model)
{
    const auto rows = static_cast<int> (model.actuators());
    ReportSection section;
    section.heading = "Participation";
    section.figures.push_back ({ "Participation of each ceramic in each mode, relative to the ceramic that excites the "
                                 "mode most. Two ceramics with opposite colours need voltages of opposite sign.",
                                 {},
                                 participationChart (model),
                                 reportFigureWidth,
                                 std::clamp (aroundMatrix + matrixRowHeight * rows, lowestMatrix, highestMatrix) });
    return section;
}

std::vector<std::string> tableRow (const ModalModel& model, Eigen::Index mode)
{
    std::vector<std::string> row { std::to_string (mode + 1), formatted ("%.2f", model.frequencyHz (mode)),
                                   formatted ("%.1f", 0.5 / model.dampingRatios[mode]) };

    if (model.frequencyErrors.size() > 0)
        row.push_back (formatted ("%.1e", model.frequencyErrors[mode]));

    if (const auto error = usualModelError (model))
        row.push_back (formatted ("%.1e", *error));

    if (model.actuators() > 0)
    {
        Eigen::Index best = 0;
        const auto largest = model.participation.row (mode).cwiseAbs().maxCoeff (&best);
        row.push_back (model.ceramics[static_cast<std::size_t> (best)].name);
        row.push_back (formatted ("%.4g", largest));
    }

    return row;
}

ReportSection tableSection (const ModalModel& model)
{
    ReportTable table { "Modes", { "mode", "frequency (Hz)", "Q" }, {} };

    if (model.frequencyErrors.size() > 0)
        table.header.emplace_back (usualModelError (model) ? "error of the solver" : "estimated error");

    if (usualModelError (model))
        table.header.emplace_back ("of the model, usually");

    if (model.actuators() > 0)
        table.header.insert (
            table.header.end(),
            { "strongest ceramic", "its participation (N kg\xE2\x81\xBB\xC2\xB9\xE2\x81\x84\xC2\xB2 / V)" });

    for (Eigen::Index mode = 0; mode < model.modes(); ++mode)
        table.rows.push_back (tableRow (model, mode));

    ReportSection section;
    section.heading = "Table of modes";
    section.paragraphs = { "Q is the quality factor. Errors are relative to the frequency." };

    if (usualModelError (model))
        section.paragraphs.push_back ("The error of the solver is that of the numerical solution alone. That of the "
                                      "model is the usual difference of devices from their description, in dimensions, "
                                      "materials and edges; a few measured points (antinode retune) remove it.");

    section.tables.push_back (std::move (table));
    return section;
}
} // namespace

ReportPage modesReport (const ModalModel& model, const std::vector<PathPiece>& elastic)
{
    ReportPage page;
    page.title = model.name + ": modes";
    page.subtitle = std::to_string (model.modes()) + " modes from " + inWords (model.frequencyHz (0)) + " Hz to "
                    + inWords (model.frequencyHz (model.modes() - 1)) + " Hz, " + std::to_string (model.actuators())
                    + " ceramics";
    page.sections = { deviceSection (model, elastic), shapeSection (model) };

    if (model.actuators() > 0)
        page.sections.push_back (participationSection (model));

    page.sections.push_back (tableSection (model));
    page.footer = "Antinode " ANTINODE_VERSION;
    return page;
}

bool isPlate (const ModalModel& model)
{
    return model.surface.kind == SurfaceKind::plate;
}

namespace
{
constexpr int modeMapCells = 110;                  // along the longer side of a plate
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
    const auto maps = fieldMaps (model.surface, model.shapes.leftCols (count), modeMapCells);
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
