#include "FocusScores.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_charts/Numbers.h>
#include <antinode_focus/LimitWords.h>

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
} // namespace

std::vector<ReportScore> focusScores (const RenderedFocus& focus)
{
    const auto& design = focus.design;
    const auto limit = inWords (design.program.voltageLimits.maxCoeff());
    const auto peakVoltage = focus.render.voltages.cwiseAbs().maxCoeff();
    const auto peakVelocity = focus.reachedField.cwiseAbs().maxCoeff() * milli;
    std::vector<ReportScore> scores {
        { "v-score", formatFixed (focus.truncatedScore.vScore, 5),
          "Correlation of the reached field with the part of the wanted field that the controlled modes can represent; "
          "with the wanted field itself it is "
              + formatFixed (focus.score.vScore, 4) + ". 1 is best." },
        { "Field error", percentInWords (focus.truncatedScore.fieldError),
          "RMS difference from the part of the wanted field that the controlled modes can represent; from the wanted "
          "field itself it is "
              + percentInWords (focus.score.fieldError) + "." },
        { "Captured", formatFixed (design.captured, 4),
          "Fraction of the wanted field (square root of energy) that the "
              + std::to_string (design.controlledModes.size()) + " controlled modes represent. 1 is all of it." },
        { "Peak velocity", inWords (peakVelocity) + " mm/s",
          "Largest velocity anywhere on the surface at the focus; " + percentInWords (focus.score.peakRatio)
              + " of the wanted velocity at its position." },
        { "Peak voltage", inWords (peakVoltage) + " V",
          "Largest voltage of any ceramic; the limit is " + limit + " V. " + limitText (focus)
              + "No waveform can reach this focus below " + inWords (design.lowerBoundVoltage)
              + " V; this bound is tight to " + percentInWords (design.lowerBoundGap) + "." },
        { "Contrast", inWords (focus.contrast),
          "Peak divided by the RMS velocity outside the focal spot at the same instant." },
    };

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
