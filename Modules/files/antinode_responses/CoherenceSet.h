#pragma once

#include "UniversalSets.h"

namespace antinode
{
/** The coherence that belongs to a response. @param values  as many as the response has [any] */
UniversalFunction coherenceSet (UniversalFunction response, const Eigen::VectorXd& values);
} // namespace antinode
