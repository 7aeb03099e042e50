#pragma once

#include "FocusDescription.h"

#include <antinode_model/Surface.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace antinode
{
/** One target's profile: 1 at its centre, 1/2 at half its width.
    @param distance  m, from the centre, of either sign
    @param width     full width at half maximum, m
    [any] Docs/Theory.md, section 2.1; paper (34) for the bump. */
double targetProfile (TargetShape, double distance, double width);

/** The wanted velocity v* on the surface's points: the sum of all targets.
    @param edgeWindow  Tukey taper, the share of the surface's length that is tapered (half of it at either end where
   the edge is held; of a surface with a boundary that share of its shorter extent, along what holds it), or none
    @return            N_p values, m/s
    [any] Docs/Theory.md, section 2.1. */
Eigen::VectorXd targetField (const Surface&, const std::vector<Target>&, std::optional<double> edgeWindow);

/** The same at one place, on the surface's points or between them. m/s [any] */
double targetVelocity (const Surface&, const std::vector<Target>&, std::optional<double> edgeWindow, double x,
                       double y);

/** Peak over RMS, weighted by area, outside the focal spots: farther than a width from every target's centre, each axis
   in its own width. 0 where nothing lies outside or moves.
    @param field  N_p values, m/s
    @param peak   m/s, of either sign: what largestVelocity finds
    [any] Docs/Theory.md, section 5. */
double fieldContrast (const Surface&, const Eigen::VectorXd& field, const std::vector<Target>&, double peak);
} // namespace antinode
