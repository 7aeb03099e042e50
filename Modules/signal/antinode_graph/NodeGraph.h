#pragma once

#include "Node.h"

#include <antinode_engine/AlignedBuffers.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

namespace antinode
{
/** Nodes one after the other, compiled into a list with buffers: the real-time path. Each node takes all outputs of
    one that was added before, or nothing; the graph's outputs are those of the nodes that are named so, in that
    order. */
class NodeGraph
{
public:
    static constexpr int noSource = -1;

    /** Adds a node. @param source  index of the node whose outputs it takes, or noSource
        @return  its index
        @throws InputError  when the numbers of channels do not agree
        [worker] */
    int add (std::unique_ptr<Node>, int source);

    /** Whose outputs are the graph's. [worker] */
    void setOutputs (std::vector<int> nodes);

    int outputs() const;
    int nodes() const { return static_cast<int> (entries.size()); }
    Node& node (int index) { return *entries[static_cast<std::size_t> (index)].node; }

    /** Prepares all nodes and makes the buffers. [worker] allocates */
    void prepare (const NodeFormat&);

    /** Plays a block in parts of at most the prepared length, and hands each event to the part that it lies in.
        This is the only place that cuts blocks: a part that is longer than the nodes were prepared for never
        reaches them.
        @param hear  called after each part with its first sample, its length and outputs() pointers to what it gave
                       [audio thread] allocates nothing, locks nothing; a block of length 0 is one part, for its
                       events */
    template <typename Hear>
    void processParts (int count, std::span<const FocusEvent> events, Hear&& hear)
    {
        auto offset = 0;
        auto next = events.begin();

        do
        {
            const auto length = std::min (longestBlock, count - offset);
            const auto end = offset + length;
            processPart (length, takePartEvents (next, events.end(), offset, end < count ? end : noEnd));
            hear (offset, length, outputPointers.data());
            offset += length;
        } while (offset < count);
    }

    /** The same into the caller's channels.
        @param channels  outputs() pointers
        [audio thread] allocates nothing, locks nothing */
    void process (double* const* channels, int count, std::span<const FocusEvent> events);

    /** [audio thread] */
    void reset();

private:
    struct Entry
    {
        std::unique_ptr<Node> node;
        int source = noSource;
        PlanarBuffer<double> buffer; ///< Of its outputs.
    };

    using Events = std::span<const FocusEvent>;
    static constexpr int noEnd =
        std::numeric_limits<int>::max(); ///< Of the last part: it takes all events that are left.

    Events takePartEvents (Events::iterator& next, Events::iterator last, int offset, int end);
    void processPart (int count, Events events);

    std::vector<Entry> entries;
    std::vector<int> outputNodes;
    std::vector<FocusEvent> partEvents;
    std::vector<const double*> outputPointers;
    int longestBlock = 1;
};
} // namespace antinode
