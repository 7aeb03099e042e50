#include "InputNode.h"

#include <algorithm>

namespace antinode
{
namespace
{
template <typename Sample>
void copyScaled (const Sample* from, double* to, int count, double gain)
{
    for (int n = 0; n < count; ++n)
        to[n] = static_cast<double> (from[n]) * gain;
}
} // namespace

void InputNode::give (std::span<const float* const> from, double scale)
{
    floats = from;
    doubles = {};
    gain = scale;
    position = 0;
}

void InputNode::give (std::span<const double* const> from, double scale)
{
    floats = {};
    doubles = from;
    gain = scale;
    position = 0;
}

void InputNode::process (const NodeBlock& block)
{
    for (int i = 0; i < channels; ++i)
    {
        const auto channel = static_cast<std::size_t> (i);

        if (channel < floats.size())
            copyScaled (floats[channel] + position, block.outputs[i], block.count, gain);
        else if (channel < doubles.size())
            copyScaled (doubles[channel] + position, block.outputs[i], block.count, gain);
        else
            std::fill_n (block.outputs[i], block.count, 0.0);
    }

    position += block.count;
}
} // namespace antinode
