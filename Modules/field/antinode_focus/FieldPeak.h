#pragma once

#include "FocusDesign.h"

#include <antinode_model/ModalModel.h>

#include <Eigen/Core>

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
} // namespace antinode
