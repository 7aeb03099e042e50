#pragma once

#include "Identification.h"
#include "PreparedResponses.h"

namespace antinode
{
/** Neighbouring lines in which poles are sought, and the part of them whose poles count: what lies outside only helps.
 */
struct SearchBand
{
    Eigen::Index firstLine = 0, lines = 0;
    double minimum = 0, maximum = 0; ///< rad/s: of poles that count.
};

/** The bands that were requested, or bands that cover all lines: each to 1.6 times its lower end, at most 2.5 kHz wide,
   with a guard of a quarter on either side, and with enough lines for polynomials.
    @throws InputError  when a band that was requested holds less than 8 lines
    [worker] Docs/Theory.md, section 8.2. */
std::vector<SearchBand> searchBands (const PreparedResponses&, const std::vector<FrequencyBand>& wanted);

/** The two halves of a band, each with guards of its own; none if they would have too few lines. [any] */
std::vector<SearchBand> splitBand (const PreparedResponses&, const SearchBand&);
} // namespace antinode
