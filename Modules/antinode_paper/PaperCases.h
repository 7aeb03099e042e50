#pragma once

#include <antinode_base/ShowProgress.h>
#include <antinode_render/RenderedFocus.h>

#include <array>
#include <optional>
#include <vector>

namespace antinode
{
/** The spread of the plates of the detuned scores, and their number. */
struct DetuningLevel
{
    double frequency, damping, participation; ///< Relative standard deviations.
};

inline constexpr std::array<DetuningLevel, 3> paperDetuning {
    { { 0.0025, 0.1, 0.05 }, { 0.001, 0.1, 0.05 }, { 0.005, 0.2, 0.1 } }
};
inline constexpr int paperDraws = 51;

/** Growths for which both drives are set side by side: chosen by the program, and two of the print's. */
inline constexpr std::array<std::optional<double>, 3> paperGrowths { std::nullopt, 1.0, 4.0 };

/** Peak voltages of the minimum-norm allocation of (29), V, with the paper's drive (constant included) and offset-free.
 */
struct DrivePeaks
{
    double paper = 0, offsetFree = 0;
};

/** One cell of the paper's tables: a shape on a place, played three ways. */
struct PaperCell
{
    RenderedFocus exact;                                    ///< Exact terminal rows, soft guards.
    RenderedFocus paper;                                    ///< The paper's rows (29).
    std::array<DrivePeaks, paperGrowths.size()> drivePeaks; ///< One for each of paperGrowths.
    int modesNeeded = 0; ///< The number of modes that reach Table C.1; 0 if all modes do not.
    std::array<double, paperDetuning.size()> detunedVScore {}; ///< Median over the draws, against the truncated field.
};

/** All cells, row by row of paperTables, places P1 to P5. Deterministic.
    @param model  the demonstrator
    [worker] */
std::vector<PaperCell> evaluatePaperCells (const ModalModel&, const ShowProgress&);

/** The median v-score of one design on plates drawn around the model, against its truncated field, in closed form.
    [worker] Docs/Theory.md, section 7. */
double medianDetunedVScore (const ModalModel&, const FocusDesign&, const DetuningLevel&, int draws);
} // namespace antinode
