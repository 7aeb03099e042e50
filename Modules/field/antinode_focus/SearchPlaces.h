#pragma once

#include "FieldPeak.h"

#include <vector>

namespace antinode
{
/** Where a search for a peak starts: a place on the surface, or on the boundary of a focal spot. */
struct PeakStart
{
    FieldPeak at;
    int spot = -1;    ///< Index of the focal spot; -1: the place is free.
    double angle = 0; ///< On the boundary of the spot.
};

/** How far apart the starts lie, and so how far a search looks. 0: it does not move in that direction. */
struct PeakSteps
{
    double x = 0, y = 0, time = 0; ///< m, m, s
};

/** Places where a field is looked at first. */
struct SearchPlaces
{
    std::vector<PeakStart> starts; ///< Outside the focal spots, and on their boundaries.
    Eigen::MatrixXd shapes;        ///< Starts x N_m
    PeakSteps steps;
    std::size_t alongBoundary = 0; ///< How many of them, all together, lie along the boundary of the surface.
};

/** Even places over a surface, edges included, or its points where these lie on no grid; of a surface with a boundary
   those within it and others all along it.
    @param density  places per point of the surface along each axis
    [worker] */
SearchPlaces searchPlaces (const ModalModel&, double density, const std::vector<FocalSpot>& outside);
} // namespace antinode
