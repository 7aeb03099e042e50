#include "SlewNode.h"

#include <utility>

namespace antinode
{
SlewNode::SlewNode (Eigen::VectorXd limitsToKeep, Eigen::VectorXd slewsToKeep)
    : limits (std::move (limitsToKeep)), slews (std::move (slewsToKeep))
{
}

void SlewNode::prepare (const NodeFormat& format)
{
    limiter.emplace (limits, slews, format.sampleRate);
}

void SlewNode::reset()
{
    if (limiter)
        limiter->reset();
}

void SlewNode::process (const NodeBlock& block)
{
    limiter->process (block.inputs, block.outputs, block.count);
}
} // namespace antinode
