#pragma once

#include "ForceNode.h"

namespace antinode
{
/** Shares force oscillations out among ceramics, those of each voice by the allocation of its own focus. */
class AllocationNode : public Node
{
public:
    /** @param forces    whose voices are shared out; its outputs reach this node in the same block, changed by
                       other nodes or not. It outlives this
        @param ceramics  channels, V */
    AllocationNode (const ForceNode& forces, int ceramics);

    std::string name() const override { return "Allocation"; }
    int inputs() const override { return forces.outputs(); }
    int outputs() const override { return ceramics; }
    void prepare (const NodeFormat&) override {}
    void process (const NodeBlock&) override;
    void reset() override {}

private:
    void addVoltages (const ForceStretch&, const NodeBlock&) const;

    const ForceNode& forces;
    int ceramics;
};
} // namespace antinode
