#pragma once

#include "Identification.h"

#include <optional>

namespace antinode
{
/** Low-passes of first order of amplifier, drivers or sensors that the phases of residues show. */
struct ChannelFilters
{
    Eigen::MatrixXd timeConstants; ///< N_p x N_b: s; 0 where there is none.
    std::string said;              ///< What was found, as a sentence.
};

/** Looks for one low-pass of all responses, one of each reference, or one of each point, by test of hypotheses: phases
    of free residues must follow it with a risk of 0.1 %, by three quarters, and better than delays of channels or
    resonances that differ from channel to channel.
    @return  nothing where modes are fewer than four, or phases are those of modes
    [worker] Docs/Theory.md, section 8.5. */
std::optional<ChannelFilters> findChannelFilters (const FrequencyResponses&, const IdentifiedModes&);

/** The responses as they were before low-passes. @param timeConstants  N_p x N_b: s [worker] */
FrequencyResponses withoutLowPasses (FrequencyResponses, const Eigen::MatrixXd& timeConstants);
} // namespace antinode
