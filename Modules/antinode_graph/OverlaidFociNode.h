#pragma once

#include "PlayerNode.h"

namespace antinode
{
/** Foci on top of other voltages: what comes in, with the voltages of the voices added. */
class OverlaidFociNode : public Node
{
public:
    OverlaidFociNode (int ceramics, const PlayerSettings& settings) : player (ceramics, settings) {}

    std::string name() const override { return "Foci on top"; }
    int inputs() const override { return player.outputs(); }
    int outputs() const override { return player.outputs(); }
    void prepare (const NodeFormat& format) override { player.prepare (format); }
    void process (const NodeBlock&) override;
    void reset() override { player.reset(); }

    /** As VoiceNode has it. */
    FocusVoices& voices() { return player.voices(); }

private:
    PlayerNode player;
};
} // namespace antinode
