#include "ForceNode.h"

#include <algorithm>
#include <array>

namespace antinode
{
ForceNode::ForceNode (VoltageProgram programToUse) : program (std::move (programToUse)) {}

void ForceNode::prepare (const NodeFormat& format)
{
    auto forces = program;
    forces.allocation = Eigen::MatrixXd::Identity (outputs(), outputs());
    synthesiser.emplace (forces, Playback { Reconstruction::bandLimited, format.sampleRate });
    isPlaying = false;
}

template <typename Sample>
void ForceNode::add (const NodeBlock<Sample>& block, int from, int to)
{
    // As many pointers as fit on the stack at a time would need a synthesiser a part: forces are few enough for one list of them.
    constexpr std::size_t most = 4096;
    std::array<Sample*, most> shifted;
    const auto count = std::min (static_cast<std::size_t> (outputs()), most);

    for (std::size_t i = 0; i < count; ++i)
        shifted[i] = block.outputs[i] + from;

    synthesiser->add (time, to - from, amplitude, shifted.data());
    time += to - from;
}

template <typename Sample>
void ForceNode::play (const NodeBlock<Sample>& block)
{
    for (int i = 0; i < outputs(); ++i)
        std::fill (block.outputs[i], block.outputs[i] + block.count, Sample (0));

    auto done = 0;
    const auto playTo = [&] (int end)
    {
        if (isPlaying)
            add (block, done, end);

        done = end;
    };

    for (const auto& event : block.events)
    {
        playTo (std::clamp (event.offset, done, std::max (done, block.count)));

        if (event.kind == FocusEventKind::trigger)
        {
            isPlaying = true;
            amplitude = event.amplitude;
            time = 0;
        }
    }

    playTo (block.count);
}

void ForceNode::process (const NodeBlock<float>& block)
{
    play (block);
}

void ForceNode::process (const NodeBlock<double>& block)
{
    play (block);
}
} // namespace antinode
