#pragma once

#include "DeviceDescription.h"

#include <optional>

namespace antinode
{
/** Where ceramics of one kind may go on a bare device, and what each would move there. */
struct PlacementCandidates
{
    std::vector<CeramicDescription> ceramics;
    Eigen::MatrixXd participation;                     ///< N_m x candidates, of the bare device's modes.
    Eigen::VectorXd angularFrequencies, dampingRatios; ///< N_m, of the bare device.

    /** Whether two of them would overlap. [any] */
    bool overlap (Eigen::Index a, Eigen::Index b) const;
};

struct CandidateGrid
{
    double step = 0;           ///< Between neighbouring positions, m, more than 0.
    std::optional<double> rim; ///< On a plate: only within this distance of its edges, m.
    int modes = 40;            ///< How many of the lowest modes.
};

/** The candidates for ceramics like a given one on a beam, staple or plate; those that the device carries are left out, their mass and
    stiffness are not counted.
    @throws InputError  when the ceramic does not fit, there are more than 5000 candidates, or the device's modes are given
    [worker] Docs/Theory.md, section 1.9. */
PlacementCandidates placementCandidates (const DeviceDescription&, const CeramicDescription& like,
                                         const CandidateGrid&);

/** The device with other ceramics. [any] */
DeviceDescription withCeramics (DeviceDescription, const std::vector<CeramicDescription>&);
} // namespace antinode
