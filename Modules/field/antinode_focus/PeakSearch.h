#pragma once

#include "SearchPlaces.h"

#include <functional>

namespace antinode
{
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
} // namespace antinode
