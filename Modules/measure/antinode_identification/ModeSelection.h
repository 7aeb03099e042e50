#pragma once

#include "NormalModeFit.h"
#include "PoleSearch.h"

namespace antinode
{
/** The candidates picked by the user: those nearest to the selected frequencies, if there are any, without those
   nearest to the rejected ones.
    @throws InputError  when no candidate lies within 2 % of a frequency
    [worker] */
std::vector<PoleCluster> picked (const std::vector<PoleCluster>&, const IdentificationOptions&);

/** Modes whose energy noise alone would not give, in ascending order; of neighbours that fail together the stronger
   stays for now.
    @param variance  E |error|^2 of a value of weight 1
    [worker] Docs/Theory.md, section 8.5. */
std::vector<Eigen::Index> standOut (const FitState&, double variance, double ridge);

/** The poles of clusters as modes without shapes. @param delay  s [any] */
NormalModes polesOf (const std::vector<PoleCluster>&, double delay);

/** Only some of the clusters, or modes, in ascending frequency. [any] */
std::vector<PoleCluster> chosen (const std::vector<PoleCluster>&, const std::vector<Eigen::Index>&);
NormalModes chosen (const NormalModes&, const std::vector<Eigen::Index>&);
} // namespace antinode
