#pragma once

#include "Node.h"

#include <span>

namespace antinode
{
/** Where samples from outside come into a graph. Before each block of the graph it is told where they are; the
    parts of the block then take them one after the other. */
class InputNode : public Node
{
public:
    /** @param channels  1 or more */
    explicit InputNode (int channelsToUse) : channels (channelsToUse) {}

    std::string name() const override { return "Input"; }
    int inputs() const override { return 0; }
    int outputs() const override { return channels; }
    void prepare (const NodeFormat&) override {}
    void process (const NodeBlock&) override;
    void reset() override {}

    /** The next block. @param from  as many channels as there are: those that are missing are silent. They must
        last until the graph has played the block
        @param scale  factor of all samples [audio thread] */
    void give (std::span<const float* const> from, double scale);
    void give (std::span<const double* const> from, double scale);

private:
    int channels;
    std::span<const float* const> floats;
    std::span<const double* const> doubles;
    double gain = 1;
    int position = 0; ///< In the block.
};
} // namespace antinode
