#include "FieldFigures.h"

#include "FocusCharts.h"
#include "PlateCharts.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>

#include <algorithm>

namespace antinode
{
namespace
{
constexpr double shownAroundFocus = 0.0015; // s

std::string millimetres (double length)
{
    return inWords (length * 1000) + " mm";
}

std::vector<ReportFigure> lineFigures (const RenderedFocus& focus)
{
    const auto& design = focus.design;
    return {
        { "Velocity at the focus: wanted, represented by the controlled modes, and reached. Ceramics are shaded.",
          {},
          fieldChart (focus.model, design.target.field, design.truncatedField, focus.reachedField),
          reportFigureWidth,
          400 },
        { "Velocity around the focus over position and time.",
          {},
          fieldOverTimeChart (focus.model, design, focus.render, shownAroundFocus),
          reportFigureWidth,
          400 },
    };
}

std::vector<ReportFigure> plateFigures (const RenderedFocus& focus)
{
    const auto& design = focus.design;
    const auto& model = focus.model;
    const auto& targets = design.description.targets;
    const auto x = millimetres (targets.front().x), y = millimetres (targets.front().y);
    return {
        { "Velocity reached at the focus. Crosses mark the foci, bold lines half of the peak, thin lines the nodal "
          "lines; ceramics are outlined.",
          {},
          plateFieldChart (model, focus.reachedField, "velocity", targets),
          reportFigureWidth,
          plateFigureHeight (model.surface, reportFigureWidth, 1, 1) },
        { "The wanted field, its part that the controlled modes represent, and the reached field in the same colours; "
          "the difference has its own colour scale.",
          {},
          plateFieldsChart (model, design, focus.reachedField),
          reportFigureWidth,
          plateFigureHeight (model.surface, reportFigureWidth, 2, 2) },
        { "Cross section along x through the focus, at y = " + y + ". Ceramics below it are shaded.",
          {},
          crossSectionChart (model, design, focus.reachedField, PlateDirection::alongX),
          reportFigureWidth,
          360 },
        { "Cross section along y through the focus, at x = " + x + ".",
          {},
          crossSectionChart (model, design, focus.reachedField, PlateDirection::alongY),
          reportFigureWidth,
          360 },
        { "Velocity around the focus over time, along x at y = " + y + ".",
          {},
          fieldOverTimeChart (model, design, focus.render, shownAroundFocus),
          reportFigureWidth,
          400 },
    };
}
} // namespace

std::vector<ReportFigure> fieldFigures (const RenderedFocus& focus)
{
    return focus.model.surface.kind == SurfaceKind::plate ? plateFigures (focus) : lineFigures (focus);
}

std::vector<ReportFigure> laterFieldFigures (const RenderedFocus& focus)
{
    const auto& model = focus.model;
    const auto isPlate = model.surface.kind == SurfaceKind::plate;
    std::vector<ReportFigure> figures;

    for (std::size_t i = 1; i < focus.moments.size(); ++i)
    {
        const auto& wanted = focus.design.moments[i];
        const auto& reached = focus.moments[i];
        const auto caption = "Velocity at the focus at "
                             + inWords (static_cast<double> (reached.sample) / focus.render.sampleRate * 1000)
                             + " ms; field error " + inWords (100 * reached.truncatedScore.fieldError) + " %.";

        if (isPlate)
            figures.push_back ({ caption,
                                 {},
                                 plateFieldChart (model, reached.field, "velocity", wanted.targets),
                                 reportFigureWidth,
                                 plateFigureHeight (model.surface, reportFigureWidth, 1, 1) });
        else
            figures.push_back ({ caption,
                                 {},
                                 fieldChart (model, wanted.target.field, wanted.truncatedField, reached.field),
                                 reportFigureWidth,
                                 400 });
    }

    return figures;
}

namespace
{
constexpr double shownLevels = 40; // dB below the strongest
constexpr int feltMapCells = 220;

Eigen::VectorXd levelsOf (const FeltOutcome& felt)
{
    Eigen::VectorXd levels (static_cast<Eigen::Index> (felt.places.size()));
    std::transform (felt.places.begin(), felt.places.end(), levels.begin(),
                    [] (const auto& place) { return place.level; });
    return levels;
}

/** Even places are a map as they are; between others it is interpolated. */
Eigen::MatrixXd levelMap (const Surface& surface, const FeltOutcome& felt)
{
    const auto levels = levelsOf (felt);

    if (felt.columns == 0)
    {
        auto scattered = surface;
        scattered.grid.reset();
        scattered.points.resize (levels.size(), 2);

        for (Eigen::Index i = 0; i < levels.size(); ++i)
            scattered.points.row (i) << felt.places[static_cast<std::size_t> (i)].x,
                felt.places[static_cast<std::size_t> (i)].y;

        return fieldMaps (scattered, levels, feltMapCells).front();
    }

    return Eigen::Map<const Eigen::MatrixXd> (levels.data(), felt.columns, levels.size() / felt.columns).transpose();
}

HeatMap feltMapChart (const ModalModel& model, const FeltOutcome& felt)
{
    const auto& surface = model.surface;
    HeatMap chart;
    chart.values = levelMap (surface, felt);
    chart.xLabel = "x (mm)";
    chart.yLabel = "y (mm)";
    chart.valueLabel = "sensation level (dB)";
    chart.x = { surface.xMinimum * milli, surface.xMaximum * milli };
    chart.y = { surface.yMinimum * milli, surface.yMaximum * milli };
    const auto top = chart.values.maxCoeff();
    chart.valueRange = AxisRange { top - shownLevels, top };
    chart.equalAspect = true;
    chart.surface = surfaceShape (surface);
    chart.rectangles = ceramicRectangles (model);
    chart.contours = { { 0 }, {} };

    for (const auto& target : felt.targets)
        chart.points.push_back ({ target.x * milli, target.y * milli, {} });

    return chart;
}

LineChart feltLineChart (const ModalModel& model, const FeltOutcome& felt)
{
    Eigen::VectorXd places (static_cast<Eigen::Index> (felt.places.size()));
    std::transform (felt.places.begin(), felt.places.end(), places.begin(),
                    [] (const auto& place) { return place.x * milli; });
    LineChart chart;
    chart.xLabel = "position (mm)";
    chart.yLabel = "sensation level (dB)";
    chart.series = { { "felt over the whole event", places, levelsOf (felt) } };
    const auto top = chart.series.front().y.maxCoeff();
    chart.yRange = AxisRange { std::min (top - shownLevels, 0.0), std::max (top, 0.0) };
    chart.limits = { { 0, "threshold" } };

    for (const auto& target : felt.targets)
        chart.markers.push_back ({ target.x * milli, "focus" });

    for (const auto& ceramic : model.ceramics)
        chart.spans.push_back ({ ceramic.xMinimum * milli, ceramic.xMaximum * milli, ceramic.name });

    return chart;
}
} // namespace

ReportSection feltSection (const RenderedFocus& focus)
{
    const auto& model = focus.model;
    const auto& felt = focus.felt.value();
    ReportSection section;
    section.heading = "What a finger feels";
    section.paragraphs = {
        "A focus is exact at one instant. Skin adds up the motion of the whole event, build-up and ringing included, "
        "below 1 kHz. Over threshold: "
            + feltInWords (model.surface, felt) + ". " + fixedText (100 * felt.feltShare, 0)
            + " % of the surface is felt.",
        "The levels are a model: displacement, weighted by the threshold at each frequency (" + felt.threshold
            + "), the larger of its peak and root 2 times its RMS within 100 ms. Persons differ by 10 to 20 dB, and a "
              "finger that rests on the surface changes its motion."
    };

    section.figures.push_back (feltFigure (model, felt));
    return section;
}

ReportFigure feltFigure (const ModalModel& model, const FeltOutcome& felt)
{
    if (model.surface.kind == SurfaceKind::line)
        return { "Sensation level over the whole event; 0 dB is the threshold.",
                 {},
                 feltLineChart (model, felt),
                 reportFigureWidth,
                 320 };

    return { "Sensation level over the whole event. The line is the threshold, 0 dB.",
             {},
             feltMapChart (model, felt),
             reportFigureWidth,
             plateFigureHeight (model.surface, reportFigureWidth, 1, 1) };
}
} // namespace antinode
