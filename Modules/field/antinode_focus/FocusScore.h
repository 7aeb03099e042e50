#pragma once

#include "FocusDesign.h"

#include <Eigen/Core>
#include <antinode_model/ModalModel.h>
#include <antinode_model/Surface.h>

#include <optional>
#include <vector>

namespace antinode
{
/** A place of the surface and the velocity there at one time. */
struct FieldPeak
{
    double x = 0, y = 0; ///< m
    double time = 0;     ///< s from the first sample; of recorded motion only.
    double velocity = 0; ///< m/s, with its sign.
};

/** The focal spot of a target: the ellipse around its centre, or the interval on a line, within one width. */
struct FocalSpot
{
    double x = 0, y = 0;             ///< m
    double radiusX = 0, radiusY = 0; ///< m: the widths in x and y.
};

/** One focal spot per target. [any] Docs/Theory.md, section 5. */
std::vector<FocalSpot> focalSpots (const std::vector<Target>&);

/** The velocity of largest magnitude anywhere on the surface, between its points too, and its place: searched on even
    places by the mode shapes, and refined there. Within 1e-3 of the largest there is.
    @param modalVelocities  N_m, m/s kg^1/2
    @param outside          focal spots that are left out; their boundaries are not
    @return                 0 m/s where nothing lies outside
    [worker] Docs/Theory.md, section 5. */
FieldPeak largestVelocity (const ModalModel&, const Eigen::VectorXd& modalVelocities,
                           const std::vector<FocalSpot>& outside = {});

/** The same of a wanted field, as targetField has it on the points. [worker] */
FieldPeak largestWanted (const Surface&, const std::vector<Target>&, std::optional<double> edgeWindow,
                         const std::vector<FocalSpot>& outside = {});

/** The largest of the field that the controlled modes represent at one of a design's moments. [worker] */
FieldPeak largestTruncated (const ModalModel&, const FocusDesign&, const FocusMoment&);

/** The peak of one target's sign nearest to its centre: uphill from there, within the focal spot. [worker] */
FieldPeak peakOfTarget (const ModalModel&, const Eigen::VectorXd& modalVelocities, const Target&);

/** The full width at half maximum of a field around a peak, along x or y.
    @return  m; none where the field does not fall to half of the peak on both sides before the surface ends
    [worker] */
std::optional<double> widthAtHalf (const ModalModel&, const Eigen::VectorXd& modalVelocities, const FieldPeak&,
                                   bool isAlongY);

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
