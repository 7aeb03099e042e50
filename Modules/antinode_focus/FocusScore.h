#pragma once

#include <antinode_model/Surface.h>

#include <Eigen/Core>

namespace antinode
{
/** The scores of a field against a wanted one. Docs/Theory.md, section 5; paper (33). */
struct FocusScore
{
    double vScore = 0;     ///< Pearson's correlation over the surface, -1 to 1. Blind to amplitude.
    double fieldError = 0; ///< RMS of the difference / RMS of the wanted field.
    double peakRatio = 0;  ///< Reached / wanted at the point where the wanted field is largest.
};

/** Scores of a field on the surface's points, weighted by area.
    @param reached, wanted  N_p values, m/s; wanted not zero everywhere
    [any] */
FocusScore scoreField (const Surface&, const Eigen::VectorXd& reached, const Eigen::VectorXd& wanted);
} // namespace antinode
