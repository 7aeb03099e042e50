#pragma once

#include "FieldPeak.h"

#include <antinode_model/Surface.h>

#include <Eigen/Core>

namespace antinode
{
struct FocusDesign;

/** How much a field resembles a wanted one. Docs/Theory.md, section 5; paper (33). */
struct FieldScore
{
    double vScore = 0;     ///< Pearson's correlation over the surface, -1 to 1. Blind to amplitude.
    double fieldError = 0; ///< RMS of the difference / RMS of the wanted field.
};

/** The scores of a focus. Docs/Theory.md, section 5. */
struct FocusScore : FieldScore
{
    double peakRatio = 0; ///< Reached / wanted where the wanted field is largest, between the points too.
};

/** Scores of a field on the surface's points, weighted by area.
    @param reached, wanted  N_p values, m/s; wanted not zero everywhere
    [any] */
FieldScore scoreField (const Surface&, const Eigen::VectorXd& reached, const Eigen::VectorXd& wanted);
/** The same, with the ratio at the peak of the wanted field.
    @param modalVelocities  N_m, reached, m/s kg^1/2
    @param wantedPeak       as largestWanted or largestTruncated finds it
    [worker] */
FocusScore scoreFocus (const ModalModel&, const Eigen::VectorXd& modalVelocities, const Eigen::VectorXd& wanted,
                       const FieldPeak& wantedPeak);

/** The field error of a design against what its controlled modes represent, the largest of its foci, by the closed
   form.
    @param model  all modes that are played, on the points of the design's
    [worker] Docs/Theory.md, section 5. */
double largestFieldError (const ModalModel& model, const FocusDesign&);
} // namespace antinode
