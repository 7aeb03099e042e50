#include "ModesReport.h"

#include "ModeCharts.h"
#include "PlateCharts.h"
#include <antinode_base/NumberText.h>
#include <antinode_identification/FrequencyDrift.h>

#include <algorithm>
#include <array>
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
} // namespace antinode
