#pragma once

#include "Identification.h"

namespace antinode
{
/** Ranges that are worth trying, Hz, within that of the options and ascending in their lower ends: each begins in a
   valley between two resonances of the lower part, since what lies below the modes (drift, suspension, integrated
   noise) may be much stronger than these, and ends where only noise follows. None where nothing suggests one.
    @throws InputError  when no line, or no column, has values
    [worker] Docs/Theory.md, section 8.2. */
std::vector<FrequencyBand> candidateRanges (const FrequencyResponses&, const IdentificationOptions&);

/** Frequencies of resonances outside of a band and within the range of the options, Hz: peaks ten times above both
   valleys beside them and above their noise.
    @throws InputError  as candidateRanges [worker] */
std::vector<double> resonancesOutside (const FrequencyBand&, const FrequencyResponses&, const IdentificationOptions&);
} // namespace antinode
