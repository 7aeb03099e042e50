#pragma once

#include <antinode_engine/FocusEvents.h>

#include <cstdint>
#include <span>
#include <string>

namespace antinode
{
/** The format that a node is prepared for. */
struct NodeFormat
{
    double sampleRate = 48000; ///< Hz
    int longestBlock = 512;    ///< Samples; blocks may be shorter, also 0.
};

/** A block of planar channels. Inputs and outputs do not overlap. */
struct NodeBlock
{
    const double* const* inputs = nullptr; ///< One pointer per channel.
    double* const* outputs = nullptr;      ///< The same; what they hold is overwritten.
    int count = 0;                         ///< Samples.
    std::span<const FocusEvent> events;    ///< Of this block, for nodes that play.
};

/** A step of the signal path: a number of channels in, a number of channels out. A new kind of node is a class of this
   in a file of its own and one line where a graph is put together (Docs/Architecture.md, Nodes). */
class Node
{
public:
    Node() = default;
    virtual ~Node() = default;
    Node (const Node&) = delete;
    Node& operator= (const Node&) = delete;

    virtual std::string name() const = 0;
    virtual int inputs() const = 0;
    virtual int outputs() const = 0;

    /** Before the first block and after every change of the format. [worker] allocates @throws InputError */
    virtual void prepare (const NodeFormat&) = 0;

    /** [audio thread] allocates nothing, locks nothing; the result does not depend on how samples are cut into blocks
     */
    virtual void process (const NodeBlock&) = 0;

    /** Back to rest. [audio thread] */
    virtual void reset() = 0;

    /** The latency of the outputs in samples. [any, after prepare] */
    virtual std::int64_t latencySamples() const { return 0; }
};
} // namespace antinode
