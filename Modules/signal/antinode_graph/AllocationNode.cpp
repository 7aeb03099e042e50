#include "AllocationNode.h"

#include <algorithm>

namespace antinode
{
AllocationNode::AllocationNode (const ForceNode& forcesToUse, int ceramicsToUse)
    : forces (forcesToUse), ceramics (ceramicsToUse)
{
}

/** Samples are voltages of the ceramics already. */
void AllocationNode::addVoltages (const ForceStretch& stretch, const NodeBlock& block) const
{
    for (int i = 0; i < ceramics; ++i)
        for (int n = stretch.from; n < stretch.to; ++n)
            block.outputs[i][n] += block.inputs[stretch.first + i][n];
}

void AllocationNode::process (const NodeBlock& block)
{
    for (int i = 0; i < ceramics; ++i)
        std::fill_n (block.outputs[i], block.count, 0.0);

    for (const auto& stretch : forces.stretches())
        if (stretch.design != nullptr)
            stretch.design->mix (block.inputs + stretch.first, stretch.from, stretch.to, block.outputs);
        else
            addVoltages (stretch, block);
}
} // namespace antinode
