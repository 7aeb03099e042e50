#pragma once

#include "InputNodes.h"
#include "NodeGraph.h"
#include "OutputNodes.h"
#include "SurfaceNode.h"
#include "VoiceNode.h"

#include <antinode_model/ModalModel.h>

#include <Eigen/Core>

#include <functional>
#include <memory>

namespace antinode
{
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

/** Whether forces and allocation are fused in a player or stand apart, with the same samples, and what stands between
    nodes then. Docs/Design/engine.md */
struct GraphChoice
{
    bool isOpen = false;
    InsertNodes insert = {}; ///< Of the open graph, called once for every place, in their order; none: nothing.
};

/** Which nodes an instrument has, beside voices, gains, limiter, and what undoes lags of ceramics. */
struct InstrumentNodes
{
    PlayerSettings settings = {};
    GraphChoice choice = {};                  ///< Of an instrument without filters.
    std::unique_ptr<FilterNode> filters = {}; ///< Tracks for fingers, on top of which foci play; none: foci alone.
    Eigen::MatrixXd probeShapes = {};         ///< Of the monitor, N_probes x N_c, kg^-1/2; no rows: there is none.
};

/** The graph that all instruments play: inputs and filters, voices, slew rates, channel gains, limiter, a plate for the
    monitor, and what undoes lags of ceramics. */
struct InstrumentGraph
{
    NodeGraph graph; ///< Outputs: the voltages that ceramics act on, then the velocity at each probe, then, where there
                     ///< are lags, the voltages that are asked for.
    LagOutputs lags; ///< Behind the limiter.
    int input = NodeGraph::noSource, filters = NodeGraph::noSource, voices = 0, gains = 0, limiter = 0,
        plate = NodeGraph::noSource; ///< Indices of its nodes; noSource: there is none.

    VoiceNode& voiceNode() { return static_cast<VoiceNode&> (graph.node (voices)); }
    ChannelGainNode& gainNode() { return static_cast<ChannelGainNode&> (graph.node (gains)); }
    LimiterNode& limiterNode() { return static_cast<LimiterNode&> (graph.node (limiter)); }

    /** Where there are filters. */
    FilterNode& filterNode() { return static_cast<FilterNode&> (graph.node (filters)); }

    /** Where there is a monitor. */
    PlateNode& plateNode() { return static_cast<PlateNode&> (graph.node (plate)); }
};

/** @throws InputError  when sizes do not agree
    [worker] */
InstrumentGraph instrumentGraph (const std::shared_ptr<const ModalModel>&, InstrumentNodes);
} // namespace antinode
