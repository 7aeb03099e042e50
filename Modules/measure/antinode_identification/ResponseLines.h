#pragma once

#include "IdentifiedModes.h"

namespace antinode
{
/** The lines that were used for the modes, as indices. [any] */
std::vector<Eigen::Index> usedLines (const FrequencyResponses&, const IdentifiedModes&);

/** At most so many of these lines, the first and the last among them: their density follows the narrowest half width
   near them, so that every resonance keeps its form. All of them if they are no more than that.
    @param count  at least 2
    @return       ascending
    [any] */
std::vector<Eigen::Index> thinnedLines (const std::vector<Eigen::Index>&, const FrequencyResponses&,
                                        const IdentifiedModes&, Eigen::Index count);

/** The responses at some of their lines. [worker] */
FrequencyResponses atLines (const FrequencyResponses&, const std::vector<Eigen::Index>&);
} // namespace antinode
