#pragma once

#include "PolynomialPoles.h"

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
} // namespace antinode
