#include "SlewNode.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace antinode
{
namespace
{
constexpr double aboveLimit = 1.001; // so that the limiter clamps, and counts, what is beyond
}

SlewNode::SlewNode (const Eigen::VectorXd& limitsToKeep, Eigen::VectorXd slewsToKeep)
    : limits (aboveLimit * limitsToKeep), slews (std::move (slewsToKeep)), steps (limits.size()),
      last (Eigen::VectorXd::Zero (limits.size()))
{
}

void SlewNode::prepare (const NodeFormat& format)
{
    for (Eigen::Index i = 0; i < slews.size(); ++i)
        steps[i] = slews[i] > 0 ? slews[i] / format.sampleRate : std::numeric_limits<double>::infinity();
}

template <typename Sample>
void SlewNode::follow (const NodeBlock<Sample>& block)
{
    for (Eigen::Index i = 0; i < limits.size(); ++i)
        for (int n = 0; n < block.count; ++n)
        {
            const auto wanted = static_cast<double> (block.inputs[i][n]);

            // The limiter mutes what is not finite.
            if (std::isfinite (wanted))
                last[i] += std::clamp (std::clamp (wanted, -limits[i], limits[i]) - last[i], -steps[i], steps[i]);

            block.outputs[i][n] = std::isfinite (wanted) ? static_cast<Sample> (last[i]) : block.inputs[i][n];
        }
}

void SlewNode::process (const NodeBlock<float>& block)
{
    follow (block);
}

void SlewNode::process (const NodeBlock<double>& block)
{
    follow (block);
}
} // namespace antinode
