#pragma once

#include "NodeGraph.h"
#include "PlayerNode.h"

#include <antinode_model/ModalModel.h>

namespace antinode
{
/** The graph that everything plays: player, limiter, plate. */
struct StandardGraph
{
    NodeGraph graph;                        ///< Outputs: the voltages of all ceramics, then the velocity at each probe.
    int player = 0, limiter = 0, plate = 0; ///< Indices of its nodes.

    PlayerNode& playerNode() { return static_cast<PlayerNode&> (graph.node (player)); }
};

/** @param probeShapes  N_probes x N_m, kg^-1/2
    @throws InputError  when sizes do not agree
    [worker] */
StandardGraph standardGraph (const std::shared_ptr<const ModalModel>&, const PlayerSettings&,
                             const Eigen::MatrixXd& probeShapes);
} // namespace antinode
