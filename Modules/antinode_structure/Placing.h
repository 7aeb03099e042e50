#pragma once

#include "PlacementCandidates.h"
#include "PlacementSearch.h"

namespace antinode
{
/** Where ceramics of a kind best go on a device. */
struct PlacedCeramics
{
    std::vector<CeramicDescription> ceramics; ///< Named C1, C2 and so on.
    double controllability = 0;     ///< Worst, relative to ceramics in average places that do not couple modes.
    std::optional<double> resolved; ///< The same with the ceramics' mass and stiffness.
    Eigen::VectorXd perMode;        ///< N_m: the Gramian's diagonal, likewise relative.
    Eigen::Index candidates = 0;
    int exchanges = 0;
};

struct PlacingOptions
{
    CandidateGrid grid;
    Eigen::Index count = 0;  ///< How many ceramics.
    double duration = 0.025; ///< s within which the modes are to be moved.
    bool isResolved = true;  ///< Whether the device is solved again with its ceramics.
};

/** Chooses places by the worst controllability of the lowest modes, on the bare device's modes; then solves it with its ceramics.
    @throws InputError  as placementCandidates and searchPlacement, and when some mode is moved from none of the places
    [worker], on all cores. Docs/Theory.md, section 1.9. */
PlacedCeramics placeCeramics (const DeviceDescription&, const CeramicDescription& like, const PlacingOptions&,
                              const std::function<void (double)>& progress = {});
} // namespace antinode
