#pragma once

#include "Node.h"

#include <antinode_engine/PlanarBuffer.h>

#include <memory>
#include <vector>

namespace antinode
{
/** Nodes one after the other, compiled into a list with buffers: the real-time path. Each node takes all outputs of one that was
    added before, or nothing; the graph's outputs are those of the nodes that are named so, in that order. */
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

    /** Prepares all nodes and makes the buffers, for samples of both precisions. [worker] allocates */
    void prepare (const NodeFormat&);

    /** Longer blocks than prepared for are played in parts; events are handed to the part that they lie in.
        @param channels  outputs() pointers
        [audio thread] allocates nothing, locks nothing */
    template <typename Sample>
    void process (Sample* const* channels, int count, std::span<const FocusEvent> events);

    /** [audio thread] */
    void reset();

private:
    struct Entry
    {
        std::unique_ptr<Node> node;
        int source = noSource;
        PlanarBuffer<float> floats; ///< Of its outputs.
        PlanarBuffer<double> doubles;

        template <typename Sample>
        const PlanarBuffer<Sample>& buffer() const;
    };

    template <typename Sample>
    void processPart (Sample* const* channels, int offset, int count, std::span<const FocusEvent> events);

    std::vector<Entry> entries;
    std::vector<int> outputNodes;
    std::vector<FocusEvent> partEvents;
    int longestBlock = 0;
};
} // namespace antinode
