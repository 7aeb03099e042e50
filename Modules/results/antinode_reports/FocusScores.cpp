#include "FocusScores.h"

#include "Numbers.h"
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_focus/LimitWords.h>

#include <cmath>

namespace antinode
{
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
} // namespace antinode
