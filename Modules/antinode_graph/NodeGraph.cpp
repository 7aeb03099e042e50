#include "NodeGraph.h"

#include <antinode_base/InputError.h>

#include <algorithm>

namespace antinode
{
namespace
{
constexpr std::size_t mostEvents =
    4096; // of one part of a block: more go to the next part, and are left out at the last
}

template <>
const PlanarBuffer<float>& NodeGraph::Entry::buffer<float>() const
{
    return floats;
}

template <>
const PlanarBuffer<double>& NodeGraph::Entry::buffer<double>() const
{
    return doubles;
}

int NodeGraph::add (std::unique_ptr<Node> node, int source)
{
    const auto given = source == noSource ? 0 : entries.at (static_cast<std::size_t> (source)).node->outputs();

    if (node->inputs() != given)
        throw InputError ("node '" + node->name() + "'",
                          "takes " + std::to_string (node->inputs()) + " channels, but gets " + std::to_string (given));

    Entry entry;
    entry.node = std::move (node);
    entry.source = source;
    entries.push_back (std::move (entry));
    return nodes() - 1;
}

void NodeGraph::setOutputs (std::vector<int> nodesToUse)
{
    outputNodes = std::move (nodesToUse);
}

int NodeGraph::outputs() const
{
    int count = 0;

    for (const auto index : outputNodes)
        count += entries[static_cast<std::size_t> (index)].node->outputs();

    return count;
}

void NodeGraph::prepare (const NodeFormat& format)
{
    longestBlock = std::max (1, format.longestBlock);
    partEvents.reserve (mostEvents);

    for (auto& entry : entries)
    {
        entry.node->prepare (format);
        entry.floats = PlanarBuffer<float> (entry.node->outputs(), longestBlock);
        entry.doubles = PlanarBuffer<double> (entry.node->outputs(), longestBlock);
    }
}

void NodeGraph::reset()
{
    for (auto& entry : entries)
        entry.node->reset();
}

template <typename Sample>
void NodeGraph::processPart (Sample* const* channels, int offset, int count, std::span<const FocusEvent> events)
{
    for (auto& entry : entries)
    {
        NodeBlock<Sample> block;
        block.outputs = entry.template buffer<Sample>().channels();
        block.count = count;
        block.events = events;

        if (entry.source != noSource)
            block.inputs = entries[static_cast<std::size_t> (entry.source)].template buffer<Sample>().channels();

        entry.node->process (block);
    }

    for (const auto index : outputNodes)
    {
        const auto& from = entries[static_cast<std::size_t> (index)].template buffer<Sample>();

        for (std::size_t i = 0; i < from.size(); ++i)
            std::copy_n (from.channel (i), count, *channels++ + offset);
    }
}

template <typename Sample>
void NodeGraph::process (Sample* const* channels, int count, std::span<const FocusEvent> events)
{
    auto offset = 0;
    auto next = events.begin();

    do
    {
        const auto length = std::min (longestBlock, count - offset);
        const auto isLast = offset + length >= count;
        partEvents.clear();

        for (; next != events.end() && (isLast || next->offset < offset + length) && partEvents.size() < mostEvents;
             ++next)
        {
            partEvents.push_back (*next);
            partEvents.back().offset -= offset;
        }

        processPart (channels, offset, length, partEvents);
        offset += length;
    } while (offset < count);
}

template void NodeGraph::process (float* const*, int, std::span<const FocusEvent>);
template void NodeGraph::process (double* const*, int, std::span<const FocusEvent>);
} // namespace antinode
