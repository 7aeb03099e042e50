#include "OverlaidFociNode.h"

#include <algorithm>
#include <functional>

namespace antinode
{
void OverlaidFociNode::process (const NodeBlock& block)
{
    PlayerNode::process (block);

    for (int i = 0; i < outputs(); ++i)
        std::transform (block.inputs[i], block.inputs[i] + block.count, block.outputs[i], block.outputs[i],
                        std::plus<>());
}
} // namespace antinode
