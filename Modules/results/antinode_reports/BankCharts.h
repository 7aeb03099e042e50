#pragma once

#include "Chart.h"

#include <antinode_model/ModalModel.h>

#include <string>
#include <utility>
#include <vector>

namespace antinode
{
/** The foci of a bank's places. */
struct BankVolts
{
    std::vector<std::pair<double, double>> places; ///< x, y in m, row by row from the lower left corner.
    std::vector<double> peaks;                     ///< V, one per place; 0: no focus.
    std::vector<double> bounds;                    ///< V, what no waveform goes below; 0: not known.
    double limit = 0;                              ///< V
};

/** What each place needs: of a plate a map, of a line a curve above that of the bounds, where they are known. [any] */
Chart bankVoltsChart (const ModalModel&, const BankVolts&);

/** What a focus needs by one method. */
struct MethodVolts
{
    std::string method;
    double peak = 0; ///< V; 0: none, the method cannot play it.
};

/** Methods side by side, with lines at the limit and at what no waveform goes below.
    @param bound  V; 0: not known
    [any] */
BarChart methodVoltsChart (const std::vector<MethodVolts>&, double bound, double limit);
} // namespace antinode
