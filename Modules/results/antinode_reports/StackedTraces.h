#pragma once

#include "Annotations.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace antinode
{
/** Many signals over one time axis, a lane for each, all with the same scale: the voltages of all ceramics.
    At the right of each lane stands its peak value, in a warning colour where it exceeds the limit. */
struct StackedTraces
{
    std::string title, xLabel; ///< The label includes the unit of start and step.
    std::string unit;          ///< Of the values, for example "V".
    std::vector<std::string> names;
    double start = 0, step = 1; ///< x of the first sample, and from one sample to the next.
    Eigen::MatrixXd values;     ///< A row for each lane, a column for each sample.
    Eigen::VectorXd limits;     ///< One for each lane: drawn at plus and minus; empty if there is none.
    std::vector<Marker> markers;
};

/** A height at which every lane and its name are legible, in pixels at scale 1. [any] */
int comfortableHeight (const StackedTraces&);
} // namespace antinode
