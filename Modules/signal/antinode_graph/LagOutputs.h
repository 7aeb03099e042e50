#pragma once

#include "LimiterNode.h"
#include "NodeGraph.h"

#include <antinode_model/ModalModel.h>

#include <cstdint>
#include <memory>

namespace antinode
{
/** What stands between the voltages that ceramics are to act on and the outputs, where ceramics lag: filters, slew
   rates and a limiter of their own. */
struct LagOutputs
{
    int filters = NodeGraph::noSource, limiter = NodeGraph::noSource; ///< Indices of nodes; noSource: nothing lags.

    /** Whether there is anything. [any] */
    explicit operator bool() const { return limiter != NodeGraph::noSource; }

    /** By how much all that is designed happens later. [any, after prepare] */
    std::int64_t lateSamples (NodeGraph&) const;
};

/** Adds them behind a node. [worker] */
LagOutputs addLagOutputs (NodeGraph&, const std::shared_ptr<const ModalModel>&, int source);
} // namespace antinode
