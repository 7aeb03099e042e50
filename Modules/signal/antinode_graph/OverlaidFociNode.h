#pragma once

#include "PlayerNode.h"

namespace antinode
{
/** Foci on top of other voltages: what comes in, with the voltages of the voices added. */
class OverlaidFociNode : public PlayerNode
{
public:
    using PlayerNode::PlayerNode;

    std::string name() const override { return "Foci on top"; }
    int inputs() const override { return outputs(); }
    void process (const NodeBlock&) override;
};
} // namespace antinode
