#pragma once

#include "Identification.h"

namespace antinode
{
/** Points on which a range or a cause can be judged: all of them, or, of more than 24, as many spread evenly over
   their numbers. [any] Docs/Design/identification.md */
std::vector<Eigen::Index> samplePoints (const FrequencyResponses&);

/** Only some of the points: a copy of their responses. [worker] */
FrequencyResponses atPoints (const FrequencyResponses&, const std::vector<Eigen::Index>& points);

/** Options for some of the points: their weights and masses. [any] */
IdentificationOptions atPoints (IdentificationOptions, const std::vector<Eigen::Index>& points);
} // namespace antinode
