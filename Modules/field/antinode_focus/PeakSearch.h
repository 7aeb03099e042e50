#pragma once

#include "FocusScore.h"

#include <functional>
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

/** A velocity, m/s, at a place, m, and a time, s. */
using VelocityFunction = std::function<double (double x, double y, double time)>;

/** Starts that are worth a search: local to their surroundings, of at least that share of the largest one, at most so
    many, the largest first. [worker] */
std::vector<PeakStart> chooseStarts (std::vector<PeakStart>, const PeakSteps&, double share, std::size_t most);

/** The extent that a search keeps to. */
struct PeakExtent
{
    const Surface& surface;
    std::vector<FocalSpot> outside = {};
    double firstTime = 0, lastTime = 0; ///< s
};

/** Goes uphill from every start, and returns the largest peak that is reached. [worker] */
FieldPeak climbToPeak (const VelocityFunction&, const std::vector<PeakStart>&, const PeakSteps&, const PeakExtent&);

/** Uphill in any number of directions: by the parabola through the neighbourhood, which shrinks to 1/100 of the steps.
    @param height  may be -infinity where it is not defined
    @return        the place reached
    [worker] */
Eigen::VectorXd climb (const std::function<double (const Eigen::VectorXd&)>& height, const Eigen::VectorXd& from,
                       const Eigen::VectorXd& steps);

/** Whether a place lies in none of the spots; their boundaries are outside. @param isLine  y does not count [any] */
bool liesOutside (const std::vector<FocalSpot>&, bool isLine, double x, double y);

/** A place on the boundary of a spot. @param angle  rad [any] */
FieldPeak placeOnBoundary (const FocalSpot&, double angle);
} // namespace antinode
