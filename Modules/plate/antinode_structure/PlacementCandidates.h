#pragma once

#include "DeviceDescription.h"

#include <optional>

namespace antinode
{
/** The candidate positions of ceramics of one kind on a bare device, and the participation of each. */
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
    double step = 0;                    ///< Between neighbouring positions, m, more than 0.
    std::optional<double> edgeDistance; ///< On a plate: the largest distance from an edge, m.
    double freeEdgeMargin = 0;          ///< Least distance from free edges and ends, m; less where it leaves no room.
    int modes = 40;                     ///< How many of the lowest modes.
};

/** The candidates for ceramics like a given one on a beam, staple or plate; ceramics already on the device are left
   out, their mass and stiffness are not counted.
    @throws InputError  when the ceramic does not fit, there are more than 5000 candidates, or the device's modes are
   given [worker] Docs/Theory.md, section 1.9. */
PlacementCandidates placementCandidates (const DeviceDescription&, const CeramicDescription& like,
                                         const CandidateGrid&);

/** The device with other ceramics. [any] */
DeviceDescription withCeramics (DeviceDescription, const std::vector<CeramicDescription>&);

/** Positions from one end to the other, symmetric about the middle, at most one step apart. @throws InputError  where
   the step is none, or they are more than 5000 [any] */
std::vector<double> candidatePositions (double from, double to, double step);

/** @throws InputError  where there are more than 5000 candidates [any] */
void requireFewCandidates (std::size_t count);

/** The candidates on a plate of any outline without ceramics: even positions at which a ceramic lies within it, on no
   point support or mass, away from all edges as a margin from free ones asks where that leaves any, with their
   participations.
    @throws InputError  as placementCandidates [worker] Docs/Theory.md, section 1.9. */
PlacementCandidates outlinedCandidates (const OutlinedPlate&, const CeramicDescription& like, const CandidateGrid&);

/** Gives candidates the frequencies, losses and moments per volt of soft layers and of thick plates.
    @param common  as solved
    [worker] Docs/Theory.md, sections 1.7 and 1.15. */
void correctCandidates (PlacementCandidates&, StructureCommon common, const CeramicDescription& like);
} // namespace antinode
