#include "FieldFigures.h"

#include "FocusCharts.h"
#include "PlateCharts.h"
#include <antinode_base/NumberText.h>

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
} // namespace antinode
