#pragma once

#include "PaperCases.h"
#include "PaperTwoModes.h"

#include <antinode_charts/Chart.h>

#include <string>
#include <vector>

namespace antinode
{
/** One figure of the reproduction. */
struct PaperFigure
{
    std::string name; ///< Its file without extension: "figure-12".
    std::string caption;
    Chart chart;
    int width = 960, height = 420; ///< Pixels at scale 1.
};

/** The paper's figures as this program computes them: 3, 4, 9 to 11, 12, 13, 14, 15, 16, 17.
    @param cells  from evaluatePaperCells
    @param study  from evaluateTwoModes
    [worker] */
std::vector<PaperFigure> paperFigures (const ModalModel&, const std::vector<PaperCell>& cells,
                                       const TwoModeStudy& study);
} // namespace antinode
