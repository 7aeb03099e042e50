#include "AllocationNode.h"

#include <algorithm>

namespace antinode
{
AllocationNode::AllocationNode (const ForceNode& forcesToUse, int ceramicsToUse)
    : forces (forcesToUse), ceramics (ceramicsToUse)
{
}

/** Samples are voltages of the ceramics already. */
template <typename Sample>
void AllocationNode::addVoltages (const ForceStretch& stretch, const NodeBlock<Sample>& block) const
{
    for (int i = 0; i < ceramics; ++i)
        for (int n = stretch.from; n < stretch.to; ++n)
            block.outputs[i][n] += block.inputs[stretch.first + i][n];
}

template <typename Sample>
void AllocationNode::mix (const NodeBlock<Sample>& block) const
{
    for (int i = 0; i < ceramics; ++i)
        std::fill_n (block.outputs[i], block.count, Sample (0));

    for (const auto& stretch : forces.stretches())
        if (stretch.design != nullptr)
            stretch.design->mix (block.inputs + stretch.first, stretch.from, stretch.to, block.outputs);
        else
            addVoltages (stretch, block);
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
