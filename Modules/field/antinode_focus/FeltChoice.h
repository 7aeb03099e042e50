#pragma once

#include <antinode_fingers/SkinThreshold.h>

#include <utility>
#include <vector>

namespace antinode
{
/** Where less is to be felt than at the targets. */
enum class FeltAt
{
    everywhere, ///< On the surface farther than feltNeighbourhood from all targets.
    fingers,    ///< At the fingers of the focus.
    places      ///< At places that are given.
};

/** The felt level elsewhere over the whole event counts in what a free waveform minimises.
    Docs/Design/allocation.md */
struct FeltChoice
{
    FeltAt at = FeltAt::everywhere;
    std::vector<std::pair<double, double>> places; ///< x, y, m; with FeltAt::places only.
    double weight = 10;      ///< At 1 the energies of voltages and of what is felt count alike, each in that of the
                             ///< design without it.
    double after = 0.02;     ///< s: how long voltages may go on after the focus.
    SkinThreshold threshold; ///< Not in files: the library's, or that of a command.
};

/** Beyond this distance from the targets nothing should be felt, m: about the width of two fingertips. */
inline constexpr double feltNeighbourhood = 0.03;
} // namespace antinode
