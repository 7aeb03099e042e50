#pragma once

#include "ChannelGainNode.h"
#include "LimiterNode.h"
#include "NodeGraph.h"
#include "PlateNode.h"
#include "PlayerNode.h"

#include <antinode_model/ModalModel.h>

namespace antinode
{
/** The graph that everything plays: player, channel gains, limiter, plate. */
struct StandardGraph
{
    NodeGraph graph; ///< Outputs: the voltages of all ceramics, then the velocity at each probe.
    int player = 0, gains = 0, limiter = 0, plate = 0; ///< Indices of its nodes.

    PlayerNode& playerNode() { return static_cast<PlayerNode&> (graph.node (player)); }
    ChannelGainNode& gainNode() { return static_cast<ChannelGainNode&> (graph.node (gains)); }
    LimiterNode& limiterNode() { return static_cast<LimiterNode&> (graph.node (limiter)); }
    PlateNode& plateNode() { return static_cast<PlateNode&> (graph.node (plate)); }
};

/** @param probeShapes  N_probes x N_m, kg^-1/2
    @throws InputError  when sizes do not agree
    [worker] */
StandardGraph standardGraph (const std::shared_ptr<const ModalModel>&, const PlayerSettings&,
                             const Eigen::MatrixXd& probeShapes);
} // namespace antinode
