#pragma once

#include "Node.h"

#include <antinode_engine/VoltageSynthesiser.h>

#include <optional>

namespace antinode
{
/** The force oscillations of one focus, a channel each: what drives the modes before it is shared out among ceramics. One
    voice, restarted by every trigger; for display, or for changes before an AllocationNode. */
class ForceNode : public Node
{
public:
    /** @param program  of which the allocation is left to an AllocationNode */
    explicit ForceNode (VoltageProgram program);

    std::string name() const override { return "Forces"; }
    int inputs() const override { return 0; }
    int outputs() const override { return static_cast<int> (program.oscillations.size()); }
    void prepare (const NodeFormat&) override;
    void process (const NodeBlock<float>&) override;
    void process (const NodeBlock<double>&) override;
    void reset() override { isPlaying = false; }

private:
    template <typename Sample>
    void play (const NodeBlock<Sample>&);
    template <typename Sample>
    void add (const NodeBlock<Sample>&, int from, int to);

    VoltageProgram program;
    std::optional<VoltageSynthesiser> synthesiser;
    bool isPlaying = false;
    double amplitude = 0;
    std::int64_t time = 0; ///< Samples since the trigger.
};
} // namespace antinode
