#pragma once

#include "Identification.h"
#include "PolynomialPoles.h"
#include "PreparedResponses.h"

namespace antinode
{
/** A pole that returns at many model orders. */
struct PoleCluster
{
    std::complex<double> pole; ///< s, 1/s: the median over the orders.
    double presence = 0;       ///< Share of the orders at which it was found.
};

/** Poles that return: at least at a share of the orders, with nearly the same frequency, damping and participation. Two
   modes of one frequency stay two where their participations differ.
    @param presence  least share of the orders, 0 to 1
    @return          ascending in frequency
    [worker] Docs/Theory.md, section 8.3. */
std::vector<PoleCluster> clusterPoles (const std::vector<OrderPoles>&, double presence);

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

/** Poles found in all bands, and all that were looked at. */
struct FoundPoles
{
    std::vector<PoleCluster> clusters;   ///< Ascending in frequency: those that are taken unless the user picks.
    std::vector<PoleCluster> candidates; ///< Also poles that are seen rarely: those among which the user picks.
    std::vector<StabilisationPoint> stabilisation;
};

/** Seeks poles band by band, on as many threads as there are processors; the result does not depend on how many.
    @throws InputError  when bands that were requested hold too few lines
    [worker] Docs/Theory.md, sections 8.2 and 8.3. */
FoundPoles searchPoles (const PreparedResponses&, const IdentificationOptions&);
} // namespace antinode
