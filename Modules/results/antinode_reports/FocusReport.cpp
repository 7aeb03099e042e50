#include "FocusReport.h"

#include "FieldFigures.h"
#include "FocusCharts.h"
#include "Ticks.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/LimitUse.h>
#include <antinode_render/Summary.h>

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
        page.sections.insert (page.sections.end() - 1, powerSection (focus.model, *focus.power));

    page.links = { { "summary.json", "summary.json" }, { "design.json", "design.json" }, { "probe.csv", "probe.csv" } };
    page.footer =
        "Antinode " ANTINODE_VERSION ". The scores are computed by the plate model from the rendered samples.";
    return page;
}

namespace
{
std::string limitText (const RenderedFocus& focus)
{
    return focus.design.limit ? limitSentence (focus.model, *focus.design.limit) + " " : "";
}

std::string percentInWords (double share)
{
    return inWords (share * 100) + " %";
}

std::string widthInWords (const std::optional<double>& width)
{
    return width ? inWords (*width * milli) + " mm" : std::string ("to the edge");
}

std::string widthsInWords (const Surface& surface, const std::optional<double>& width,
                           const std::optional<double>& widthY)
{
    return surface.kind == SurfaceKind::line ? widthInWords (width)
                                             : widthInWords (width) + " x " + widthInWords (widthY);
}

/** What was asked of a target, against what is reached. */
void addTarget (std::vector<ReportScore>& scores, const RenderedFocus& focus, const TargetOutcome& target,
                const std::string& which)
{
    const auto& surface = focus.model.surface;
    const auto& wanted = target.wanted;
    const auto velocity = wanted.phase * wanted.peakVelocity;
    scores.push_back ({ "Peak velocity" + which, inWords (target.peak.velocity * milli) + " mm/s",
                        "Wanted: " + inWords (velocity * milli)
                            + " mm/s; reached: " + percentInWords (target.peak.velocity / velocity) + " of it, and "
                            + inWords (target.velocityAtCentre * milli) + " mm/s at the wanted place." });
    scores.push_back ({ "Place" + which, placeInWords (surface, target.peak.x, target.peak.y),
                        "Where the peak is; wanted: " + placeInWords (surface, wanted.x, wanted.y) + "." });
    scores.push_back ({ "Width" + which, widthsInWords (surface, target.width, target.widthY),
                        "Full width at half maximum; wanted: "
                            + widthsInWords (surface, wanted.width, wanted.widthY.value_or (wanted.width)) + "." });
}

std::vector<ReportScore> outcomeScores (const RenderedFocus& focus, const FocusOutcome& outcome)
{
    std::vector<ReportScore> scores;

    for (std::size_t i = 0; i < outcome.targets.size(); ++i)
        addTarget (scores, focus, outcome.targets[i], outcome.targets.size() > 1 ? " " + std::to_string (i + 1) : "");

    scores.push_back (
        { "Side lobe", percentInWords (std::abs (outcome.sideLobe.velocity / focus.moments.front().peak.velocity)),
          "Largest velocity farther than one width from every target at the focus: " + sideLobeInWords (focus, outcome)
              + ". The wanted field has " + percentInWords (outcome.wantedSideLobe) + "." });
    scores.push_back ({ "Contrast of the event", inWords (outcome.eventContrast),
                        "Peak at the focus divided by the largest velocity elsewhere at any time: "
                            + elsewhereInWords (focus, outcome) + "." });

    if (const auto contrast = focus.felt ? focus.felt->contrast() : std::nullopt)
        scores.push_back (
            { "Felt contrast", fixedText (*contrast, 1) + " dB",
              "What skin feels of the whole event: " + feltInWords (focus.model.surface, *focus.felt) + "." });

    const auto end = outcome.limit.find (" limit");
    scores.push_back ({ "Limited by", outcome.limit.substr (0, end), outcome.limit });
    return scores;
}
} // namespace

std::vector<ReportScore> focusScores (const RenderedFocus& focus, const FocusOutcome& outcome)
{
    const auto& design = focus.design;
    const auto limit = inWords (design.program.voltageLimits.maxCoeff());
    const auto peakVoltage = focus.render.voltages.cwiseAbs().maxCoeff();
    auto scores = outcomeScores (focus, outcome);
    const std::vector<ReportScore> internal {
        { "Peak voltage", inWords (peakVoltage) + " V",
          "Largest voltage of any ceramic; the limit is " + limit + " V. " + limitText (focus)
              + "No waveform can reach this focus below " + inWords (design.lowerBoundVoltage)
              + " V; this bound is tight to " + percentInWords (design.lowerBoundGap) + "." },
        { "v-score", formatFixed (focus.truncatedScore.vScore, 5),
          "Correlation of the reached field with the part of the wanted field that the controlled modes can represent; "
          "with the wanted field itself it is "
              + formatFixed (focus.score.vScore, 4) + ". 1 is best." },
        { "Field error", percentInWords (focus.truncatedScore.fieldError),
          "RMS difference from the part of the wanted field that the controlled modes can represent; from the wanted "
          "field itself it is "
              + percentInWords (focus.score.fieldError) + "." },
        { "Field error, device", outcome.expected ? percentInWords (outcome.expected->median) : "not known",
          "The same on the device itself, whose modes are not those of the model: "
              + (outcome.expected ? outcome.expected->sentence : "its modes are complex") + "." },
        { "Spill-over",
          focus.model.modes() > focus.known.modes() && focus.design.description.fingers.empty()
              ? percentInWords (spillOverShare (focus))
              : "not known",
          "Motion of modes beyond those of the device: " + spillOverInWords (focus) },
        { "Captured", formatFixed (design.captured, 4),
          "Fraction of the wanted field (square root of energy) that the "
              + std::to_string (design.controlledModes.size()) + " controlled modes represent. 1 is all of it." },
        { "Contrast", inWords (focus.contrast),
          "Peak divided by the RMS velocity outside the focal spot at the same instant." },
    };
    scores.insert (scores.end(), internal.begin(), internal.end());

    if (focus.residual)
        scores.push_back ({ "Residual field", percentInWords (focus.residual->ratio),
                            "Largest velocity anywhere on the surface after the brake, "
                                + inWords (focus.residual->time * milli)
                                + " ms after the focus, relative to the peak at the focus." });

    if (design.shortestPeriod)
        scores.push_back (
            { "Shortest period", inWords (*design.shortestPeriod * milli) + " ms",
              "At this period or a longer one, all other repetitions together leave at most 1 % of the peak "
              "at each focus, and overlapping voltages stay within their limits." });

    return scores;
}

namespace
{
std::string perSecond (const RepeatedPower& power)
{
    return inWords (power.rate) + " events per second";
}

ReportTable onceTable (const ModalModel& model, const PowerFlow& flow)
{
    ReportTable table { "Each ceramic during one event",
                        { "ceramic", "capacitance (nF)", "peak voltage (V)", "peak slew (V/\xC2\xB5s)",
                          "peak current (mA)",
                          "peak charge (\xC2\xB5"
                          "C)",
                          "drawn (\xC2\xB5J)", "returned (\xC2\xB5J)", "heats the ceramic (\xC2\xB5J)" },
                        {} };

    for (std::size_t i = 0; i < flow.ceramics.size(); ++i)
    {
        const auto& ceramic = flow.ceramics[i];
        table.rows.push_back ({ model.ceramics[i].name, inWords (model.ceramics[i].capacitance * 1e9),
                                inWords (ceramic.peakVoltage), inWords (ceramic.peakSlew / micro),
                                inWords (ceramic.peakCurrent * milli), inWords (ceramic.peakCharge * micro),
                                inWords (ceramic.drawn * micro), inWords (ceramic.returned * micro),
                                inWords (ceramic.dielectricLoss * micro) });
    }

    return table;
}

ReportTable repeatedTable (const ModalModel& model, const RepeatedPower& power)
{
    ReportTable table { "Each ceramic at " + perSecond (power),
                        { "ceramic", "RMS voltage (V)", "RMS current (mA)", "real power (mW)", "reactive power (mvar)",
                          "heat in the ceramic (mW)", "warming, estimate (K)" },
                        {} };

    for (std::size_t i = 0; i < power.ceramics.size(); ++i)
    {
        const auto& ceramic = power.ceramics[i];
        table.rows.push_back ({ model.ceramics[i].name, inWords (ceramic.rmsVoltage),
                                inWords (ceramic.rmsCurrent * milli), inWords (ceramic.realPower * milli),
                                inWords (ceramic.reactivePower * milli), inWords (ceramic.dielectricPower * milli),
                                model.ceramics[i].area > 0 ? inWords (ceramic.warming) : std::string ("unknown") });
    }

    return table;
}

ReportTable amplifierTable (const RepeatedPower& power)
{
    const auto row = [] (const char* kind, const AmplifierPower& amplifier) {
        return std::vector<std::string> { kind, inWords (amplifier.supply * milli), inWords (amplifier.heat * milli) };
    };
    return { "Amplifiers at " + perSecond (power) + ", all channels together, without idle currents",
             { "kind", "from the supply (mW)", "heat (mW)" },
             { row ("linear, class B, rails at the voltage limit", power.linear),
               row ("switching, class D, takes energy back at 90 % each way", power.switching),
               row ("charge, linear, sensing capacitor of ten times the ceramic", power.charge) } };
}
} // namespace

ReportSection powerSection (const ModalModel& model, const FocusPower& power)
{
    ReportSection section;
    section.heading = "Power, energy and current";

    if (! power.obstacle.empty())
    {
        section.paragraphs = { "Unknown: " + power.obstacle + "." };
        return section;
    }

    const auto& once = power.once;
    section.paragraphs = {
        "One event takes " + inWords (once.drawn() * micro) + " \xC2\xB5J from the amplifiers and gives back "
            + inWords (once.returned() * micro) + " \xC2\xB5J. Of the difference, "
            + inWords (once.electricalIn() * micro) + " \xC2\xB5J, dielectric loss heats the ceramics with "
            + inWords (once.dielectricLoss() * micro) + " \xC2\xB5J and damping turns "
            + inWords (once.mechanicalLoss * micro) + " \xC2\xB5J of motion into heat; "
            + inWords (once.storedAtEnd() * micro) + " \xC2\xB5J are stored at the end. This closes to "
            + inWords (100 * std::abs (once.imbalance())) + " %. The motion has at most "
            + inWords (once.peakMotion * micro) + " \xC2\xB5J. All amplifiers together give at most "
            + inWords (once.peakCurrent * milli) + " mA.",
        "At " + perSecond (power.repeated) + " the ceramics take " + inWords (power.repeated.realPower * milli)
            + " mW and " + inWords (power.repeated.reactivePower * milli) + " mvar"
            + (power.repeated.overlaps
                   ? "; events overlap at this rate, and their energies are added as if they did not"
                   : "")
            + ". " + amplifierAdvice (power.repeated),
        "Dielectric loss is that of small signals; at high fields it is several times as large. The warming is a "
        "steady state in still air with 10 W/(m\xC2\xB2 K) from one face; conduction into the body lowers it."
    };
    section.tables = { onceTable (model, once), repeatedTable (model, power.repeated),
                       amplifierTable (power.repeated) };
    return section;
}
} // namespace antinode
