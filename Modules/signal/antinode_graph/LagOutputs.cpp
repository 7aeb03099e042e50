#include "LagOutputs.h"

#include "LagNode.h"
#include "SlewNode.h"

namespace antinode
{
std::int64_t LagOutputs::lateSamples (NodeGraph& graph) const
{
    return *this ? graph.node (filters).latencySamples() : 0;
}

LagOutputs addLagOutputs (NodeGraph& graph, const std::shared_ptr<const ModalModel>& model, int source)
{
    LagOutputs added;

    if (! needsLagFilters (*model))
        return added;

    added.filters = graph.add (std::make_unique<LagNode> (model, LagDirection::undo), source);
    auto last = added.filters;

    if (const auto slews = slewLimits (*model); slews.maxCoeff() > 0)
        last = graph.add (std::make_unique<SlewNode> (voltageLimits (*model), slews), last);

    added.limiter = graph.add (std::make_unique<LimiterNode> (voltageLimits (*model)), last);
    return added;
}
} // namespace antinode
