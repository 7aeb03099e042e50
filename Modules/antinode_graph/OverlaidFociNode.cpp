#include "OverlaidFociNode.h"

#include <algorithm>
#include <functional>

namespace antinode
{
template <typename Sample>
void OverlaidFociNode::play (const NodeBlock<Sample>& block)
{
    player.process (block);

    for (int i = 0; i < outputs(); ++i)
        std::transform (block.inputs[i], block.inputs[i] + block.count, block.outputs[i], block.outputs[i],
                        std::plus<>());
}

template void OverlaidFociNode::play (const NodeBlock<float>&);
template void OverlaidFociNode::play (const NodeBlock<double>&);
} // namespace antinode
