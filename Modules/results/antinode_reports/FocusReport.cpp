#include "FocusReport.h"

#include "FeltSection.h"
#include "FieldFigures.h"
#include "FocusScores.h"
#include "PowerSection.h"

#include "FocusCharts.h"
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/FocusWords.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_render/FingerMotion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace antinode
{
namespace
{
constexpr int shownTransients = 6;

std::string probePlace (const RenderedFocus& focus, std::size_t probe)
{
    const auto [x, y] = focus.probes[probe];
    const auto place = "x = " + inWords (x * milli) + " mm";
    return focus.model.surface.kind == SurfaceKind::line ? place : place + ", y = " + inWords (y * milli) + " mm";
}

/** A little above the highest controlled mode. */
double shownFrequency (const RenderedFocus& focus)
{
    return 1.3 * focus.model.frequencyHz (focus.design.controlledModes.back());
}

ReportSection fieldSection (const RenderedFocus& focus)
{
    const auto& design = focus.design;
    ReportSection section;
    section.heading = "Field at the focus";
    section.figures = fieldFigures (focus);

    for (auto& figure : laterFieldFigures (focus))
        section.figures.push_back (std::move (figure));

    // With fingers the modes that are played are not those of the design.
    if (! design.description.fingers.empty())
        return section;

    section.figures.push_back (
        { "Modal velocities at the focus. Modes without a wanted bar are not controlled, but kept small.",
          {},
          spectrumChart (focus.model, design, focus.render.focusVelocities),
          900,
          340 });
    return section;
}

ReportSection voltageSection (const RenderedFocus& focus)
{
    auto traces = voltagesChart (focus.model, focus.design.program, focus.render);
    const auto height = comfortableHeight (traces);
    ReportSection section;
    section.heading = "Voltages";
    section.figures.push_back (
        { "Voltage of each ceramic with its limits (dashed); the number at the right is its peak.",
          {},
          std::move (traces),
          900,
          height });
    return section;
}

ReportFigure transientsFigure (const RenderedFocus& focus)
{
    auto transients = transientsChart (focus.model, focus.design, focus.render, shownTransients);
    const auto height = comfortableHeight (transients);
    return { "Transients of the strongest controlled modes: the largest contribution of each mode anywhere on the "
             "surface.",
             {},
             std::move (transients),
             900,
             height };
}

ReportSection motionSection (const RenderedFocus& focus)
{
    ReportSection section;
    section.heading = "Motion over time";

    for (std::size_t i = 0; i < focus.probes.size(); ++i)
    {
        const auto place = probePlace (focus, i);
        section.figures.push_back ({ "Velocity at the probe at " + place + ".",
                                     {},
                                     probeChart (focus.render, static_cast<Eigen::Index> (i), place),
                                     900,
                                     320 });
    }

    if (focus.design.description.fingers.empty())
        section.figures.push_back (transientsFigure (focus));

    if (! focus.probes.empty())
        section.figures.push_back ({ "Spectrogram of the velocity at the first probe.",
                                     {},
                                     spectrogramChart (focus.render, 0, shownFrequency (focus)),
                                     900,
                                     360 });

    return section;
}

ReportTable modeTable (const RenderedFocus& focus)
{
    const auto& design = focus.design;
    ReportTable table { "Controlled modes",
                        { "mode", "frequency (Hz)", "Q", "wanted (mm/s \xE2\x88\x9Akg)", "reached", "growth",
                          "cycles" },
                        {} };

    for (std::size_t i = 0; i < design.controlledModes.size(); ++i)
    {
        const auto mode = design.controlledModes[i];
        table.rows.push_back (
            { std::to_string (mode + 1), fixedText (focus.known.frequencyHz (mode), 1),
              fixedText (0.5 / focus.known.dampingRatios[mode], 0),
              fixedText (design.target.modalVelocities[mode] * milli, 4),
              design.description.fingers.empty() ? fixedText (focus.render.focusVelocities[mode] * milli, 4) : "-",
              inWords (design.growth[i]), std::to_string (design.cycles[i]) });
    }

    return table;
}

ReportTable fingerTable (const RenderedFocus& focus)
{
    ReportTable table { "Fingers on the surface",
                        { "finger", "place", "radius (mm)", "mass (g)", "damping (N s/m)", "stiffness (N/mm)",
                          "known to the design", "at the focus (mm/s)", "at most (mm/s)" },
                        {} };

    for (const auto& motion : fingerMotions (focus))
    {
        const auto& finger = motion.finger;
        table.rows.push_back ({ finger.name, placeInWords (focus.model.surface, finger.x, finger.y),
                                inWords (finger.radius * milli), inWords (finger.mass * milli),
                                inWords (finger.damping), inWords (finger.stiffness / milli),
                                finger.isKnown ? "yes" : "no", inWords (motion.velocityAtFocus * milli),
                                inWords (motion.peakVelocity * milli) });
    }

    return table;
}

ReportSection designSection (const RenderedFocus& focus)
{
    const auto& design = focus.design;
    const auto& certificate = design.certificate;
    ReportSection section;
    section.heading = "Design";
    section.paragraphs = design.choices;
    section.paragraphs.push_back ("Solver: " + std::string (wordFor (allocationStatusWords, certificate.status))
                                  + ", duality gap " + inWords (certificate.gap) + ", "
                                  + std::to_string (certificate.iterations) + " iterations, "
                                  + inWords (certificate.milliseconds) + " ms. The peak of the designed voltages is "
                                  + inWords (peakVoltage (design)) + " V.");
    section.tables.push_back (modeTable (focus));

    if (! design.description.fingers.empty())
        section.tables.push_back (fingerTable (focus));

    return section;
}
} // namespace

ReportPage focusReport (const RenderedFocus& focus, const FocusOutcome& outcome)
{
    ReportPage page;
    const auto& design = focus.design;
    page.title = design.description.name.empty() ? "Focus" : design.description.name;
    page.subtitle = focus.model.name + ": " + std::to_string (focus.model.actuators()) + " ceramics, "
                    + std::to_string (focus.known.modes()) + " modes, played with "
                    + std::to_string (focus.model.modes()) + ", focus at "
                    + inWords (static_cast<double> (focus.render.focusSample) / focus.render.sampleRate * milli)
                    + " ms, " + inWords (focus.render.sampleRate) + " Hz";
    page.scores = focusScores (focus, outcome);
    page.warnings = design.warnings;
    page.sections = { fieldSection (focus), voltageSection (focus), motionSection (focus), designSection (focus) };

    if (focus.felt)
        page.sections.insert (page.sections.begin() + 1, feltSection (focus));

    if (focus.power)
        page.sections.insert (page.sections.end() - 1, powerSection (focus));

    page.links = { { "summary.json", "summary.json" }, { "design.json", "design.json" }, { "probe.csv", "probe.csv" } };
    page.footer =
        "Antinode " ANTINODE_VERSION ". The scores are computed by the plate model from the rendered samples.";
    return page;
}
} // namespace antinode
