#pragma once

#include "FitErrors.h"

namespace antinode
{
/** Takes lines of the mains, single lines far above both neighbours at multiples of 50 or 60 Hz, and points without
   any signal out of data before a fit.
    @return  what was taken out, as sentences
    [worker] Docs/Theory.md, section 8.2. */
std::vector<std::string> leaveOutDisturbed (PreparedResponses&);

/** Gives less weight to channels whose errors a fit shows to be misfit, not noise, and many times those of the others.
    @return  which, and which are much noisier than others, as sentences
    [worker] Docs/Theory.md, section 8.4. */
std::vector<std::string> weighDownMisfits (PreparedResponses&, const FitErrors&);

/** "point 3" or "point 3, driver C1" where there are several references.
    @param column  reference after reference, each with all points  [any] */
std::string channelName (const FrequencyResponses&, Eigen::Index column);
} // namespace antinode
