#pragma once

#include "DeviceDescription.h"

namespace antinode
{
/** The damping ratios of a number of modes: one for all, or a list whose last one serves the modes beyond. [any] */
Eigen::VectorXd dampingOfModes (const std::vector<double>& ratios, Eigen::Index modes);

/** Writes into a computed model what it takes over from the description as it is: name, damping, limits, and the
   ceramics with their rectangles cut to the model's surface. [worker] */
void describe (ModalModel&, const std::string& name, const StructureCommon&);

/** Gives every shape, with its slopes and participations, the sign that is agreed on: positive where, point by point,
   it first exceeds a tenth of its largest amplitude. [worker] Docs/Theory.md, section 1.2. */
void settleSigns (ModalModel&);

/** Combines modes of one frequency into those that a second moment of mass along x distinguishes: any others would be
   as good, but these do not depend on rounding. [worker] */
void settleEqualFrequencies (ModalModel&);

/** Whether a surface cannot move at such an edge. [any] */
bool isHeld (EdgeCondition);

/** The parts of a device's boundary that rest on springs, m. [any] */
std::vector<PathPiece> elasticPieces (const DeviceDescription&);

/** Extent and boundary of an outlined plate, which springs do not hold; without points. [any] */
Surface outlinedSurface (const OutlinedPlate&);
} // namespace antinode
