#pragma once

#include "DeviceDescription.h"

namespace antinode
{
/** The damping ratio of so many modes: one for all, or a list whose last one serves the modes beyond. [any] */
Eigen::VectorXd dampingOfModes (const std::vector<double>& ratios, Eigen::Index modes);

/** Writes into a computed model what it takes over from the description as it is: name, damping, limits, and the ceramics with their
    rectangles cut to the model's surface. [worker] */
void describe (ModalModel&, const std::string& name, const StructureCommon&);
} // namespace antinode
