#pragma once

#include "AllocationNode.h"
#include "ChannelGainNode.h"
#include "LagOutputs.h"
#include "LimiterNode.h"
#include "NodeGraph.h"
#include "PlateNode.h"
#include "PlayerNode.h"

#include <antinode_model/ModalModel.h>

#include <functional>

namespace antinode
{
/** The graph that everything plays: player, channel gains, limiter, plate, and what undoes lags of ceramics. Opened,
   forces and allocation stand in the player's place. */
struct StandardGraph
{
    NodeGraph graph; ///< Outputs: the voltages that ceramics act on, then the velocity at each probe, then, where there
                     ///< are lags, the voltages that are asked for.
    LagOutputs lags; ///< Behind the limiter.
    int player = 0, gains = 0, limiter = 0, plate = 0; ///< Indices of its nodes; player: where the path begins.

    /** The voices of either graph. */
    VoiceNode& voiceNode() { return static_cast<VoiceNode&> (graph.node (player)); }

    /** Of the graph that is not open. */
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

/** Between which nodes of the open graph others may stand. */
enum class GraphPlace
{
    afterForces,     ///< A channel an oscillation: ForceNode::stretches() says which are in use.
    afterAllocation, ///< One channel per ceramic, V, from here on.
    afterGains,
    afterLimiter ///< Nodes that only look on: nothing comes between the limiter and the ceramics.
};

/** Adds custom nodes to a graph that is being built.
    @param last  index of the node that gives what there is at the place
    @return      index of the node that gives it on, with as many channels; `last` where nothing is changed */
using InsertNodes = std::function<int (NodeGraph&, GraphPlace, int last)>;

/** The same samples by separate nodes: forces, allocation, gains, limiter, plate.
    @param insert  called once for every place, in their order; may be empty
    @throws InputError  when sizes do not agree
    [worker] Docs/Design/engine.md */
StandardGraph openGraph (const std::shared_ptr<const ModalModel>&, const PlayerSettings&,
                         const Eigen::MatrixXd& probeShapes, const InsertNodes& insert);
} // namespace antinode
