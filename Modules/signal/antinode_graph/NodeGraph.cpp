#include "NodeGraph.h"

#include <antinode_base/InputError.h>

#include <algorithm>

namespace antinode
{
namespace
{
constexpr std::size_t maximumEvents =
    4096; // of one part of a block: more go to the next part, and are left out at the last
} // namespace

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
    partEvents.reserve (maximumEvents);

    for (auto& entry : entries)
    {
        entry.node->prepare (format);
        entry.buffer = PlanarBuffer<double> (entry.node->outputs(), longestBlock);
    }

    outputPointers.clear();

    for (const auto index : outputNodes)
    {
        const auto& buffer = entries[static_cast<std::size_t> (index)].buffer;
        outputPointers.insert (outputPointers.end(), buffer.channels(), buffer.channels() + buffer.size());
    }
}

void NodeGraph::reset()
{
    for (auto& entry : entries)
        entry.node->reset();
}

NodeGraph::Events NodeGraph::takePartEvents (Events::iterator& next, Events::iterator last, int offset, int end)
{
    partEvents.clear();

    for (; next != last && (end == noEnd || next->offset < end) && partEvents.size() < maximumEvents; ++next)
    {
        partEvents.push_back (*next);
        partEvents.back().offset -= offset;
    }

    return partEvents;
}

void NodeGraph::processPart (int count, Events events)
{
    for (auto& entry : entries)
    {
        NodeBlock block;
        block.outputs = entry.buffer.channels();
        block.count = count;
        block.events = events;

        if (entry.source != noSource)
            block.inputs = entries[static_cast<std::size_t> (entry.source)].buffer.channels();

        entry.node->process (block);
    }
}

void NodeGraph::process (double* const* channels, int count, std::span<const FocusEvent> events)
{
    const auto width = static_cast<std::size_t> (outputs());
    processParts (count, events,
                  [&] (int offset, int length, const double* const* from)
                  {
                      for (std::size_t i = 0; i < width; ++i)
                          std::copy_n (from[i], length, channels[i] + offset);
                  });
}
} // namespace antinode
