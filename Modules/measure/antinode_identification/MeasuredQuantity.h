#pragma once

#include "Identification.h"
#include "PoleSearch.h"

#include <array>
#include <string>

namespace antinode
{
/** How far real modes explain responses if one quantity was measured. */
struct QuantityFit
{
    int integrations = 0;     ///< Of the quantity, as FrequencyResponses::integrations.
    double error = 0;         ///< dB, of what was measured, with all residual terms.
    double physicalError = 0; ///< The same with the inertia of lower and the stiffness of higher modes alone.
    double modalError = 0;    ///< The same of the modes alone.
    double delay = 0;         ///< s, beyond that of the poles' fit.
    Eigen::MatrixXd residues; ///< N_m x C: phi alpha.
};

/** Displacement, velocity and acceleration, the best first, at poles that are fitted to a few points with free
   residues. Poles are the same whatever was measured; only the phases of residues differ, by a quarter turn, or by
   twice the damping ratio.
    @param poles  to begin with
    @throws InputError  when no line, or no column, has values
    [worker] Docs/Theory.md, section 8.5. */
std::array<QuantityFit, 3> fitQuantities (const FrequencyResponses&, const IdentificationOptions&,
                                          const std::vector<PoleCluster>& poles);

/** What was measured, where nothing says it. */
struct LikelyQuantity
{
    int integrations = 0; ///< As FrequencyResponses::integrations.
    std::string said;     ///< The quantity, its margin and, where two fit, what decides: a sentence.
};

/** The quantity that explains responses best; of several that do, the one that the sign of a driving point, the delay
   or the residual terms speak for. [worker] Docs/Theory.md, section 8.5. */
LikelyQuantity likelyQuantity (const std::array<QuantityFit, 3>&, const FrequencyResponses&);

/** What contradicts the quantity that was stated, as a sentence; empty if nothing does.
    @param modes  identified from these responses with these options
    [worker] Docs/Theory.md, section 8.5. */
std::string quantityContradiction (const FrequencyResponses&, const IdentificationOptions&,
                                   const IdentifiedModes& modes);

/** The same numbers as those of another quantity: what was read as one becomes the other. [worker] */
FrequencyResponses asQuantity (FrequencyResponses, int integrations);
} // namespace antinode
