#pragma once

#include "ModalFilter.h"

namespace antinode
{
/** Where known modes are found in a measurement. N_m modes. */
struct KnownPoles
{
    Eigen::VectorXd angularFrequencies, dampingRatios; ///< N_m
    Eigen::VectorXd gains;                             ///< N_m: how much of the log likelihood each explains.
    double drift = 1;                                  ///< The median factor of frequencies.
    double delay = 0;                                  ///< s
};

/** The most probable pole of each mode from what lines say of it alone, at any phase and with an amplitude near 1:
   first with any common drift, then relative to it, then more precisely about what was found.
    @throws InputError  when none of the modes is seen
    [worker] Docs/Theory.md, section 8.7. */
KnownPoles findKnownPoles (const PreparedResponses&, const KnownModes&, const KnownSpread&);
} // namespace antinode
