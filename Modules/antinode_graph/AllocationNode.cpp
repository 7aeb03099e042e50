#include "AllocationNode.h"

#include <algorithm>

namespace antinode
{
AllocationNode::AllocationNode (Eigen::MatrixXd allocationToUse) : allocation (std::move (allocationToUse)) {}

template <typename Sample>
void AllocationNode::mix (const NodeBlock<Sample>& block) const
{
    for (int i = 0; i < outputs(); ++i)
    {
        auto* const to = block.outputs[i];
        std::fill (to, to + block.count, Sample (0));

        for (int c = 0; c < inputs(); ++c)
        {
            const auto share = static_cast<Sample> (allocation (i, c));
            const auto* const from = block.inputs[c];

            for (int n = 0; n < block.count; ++n)
                to[n] += share * from[n];
        }
    }
}

void AllocationNode::process (const NodeBlock<float>& block)
{
    mix (block);
}

void AllocationNode::process (const NodeBlock<double>& block)
{
    mix (block);
}
} // namespace antinode
