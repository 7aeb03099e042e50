#include "FocusScores.h"

#include <antinode_focus/DesignRemarks.h>
#include <antinode_views/Numbers.h>

namespace antinode
{
namespace
{
constexpr double milli = 1000;

std::string percent (double share)
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
          "Correlation of the reached field with what the controlled modes can carry; against the wanted field itself "
          "it is "
              + formatFixed (focus.score.vScore, 4) + ". 1 is best." },
        { "Field error", percent (focus.truncatedScore.fieldError),
          "RMS of the difference to what the controlled modes can carry; to the wanted field itself it is "
              + percent (focus.score.fieldError) + "." },
        { "Captured", formatFixed (design.captured, 4),
          "Share of the wanted field (root of its energy) that the " + std::to_string (design.controlledModes.size())
              + " controlled modes carry. 1 is all." },
        { "Peak velocity", inWords (peakVelocity) + " mm/s",
          "Largest velocity anywhere on the surface at the focus; " + percent (focus.score.peakRatio)
              + " of the wanted one at its place." },
        { "Peak voltage", inWords (peakVoltage) + " V",
          "Largest voltage of any ceramic; the limit is " + limit + " V. No waveform at all could do it below "
              + inWords (design.lowerBoundVoltage) + " V; this bound is tight to " + percent (design.lowerBoundGap)
              + "." },
        { "Contrast", inWords (focus.contrast),
          "Peak over RMS of the motion outside the focal spot at the same instant." },
    };

    if (focus.residual)
        scores.push_back ({ "Residual field", percent (focus.residual->ratio),
                            "Largest velocity anywhere on the surface once the brake is over, "
                                + inWords (focus.residual->time * milli)
                                + " ms after the focus, against the peak at the focus." });

    if (design.shortestPeriod)
        scores.push_back ({ "Shortest period", inWords (*design.shortestPeriod * milli) + " ms",
                            "Repeated so often or less, all other repeats together leave at most 1 % of the peak at "
                            "each focus, and voltages that overlap keep their limits." });

    return scores;
}
} // namespace antinode
