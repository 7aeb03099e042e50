#pragma once

#include "VoiceNode.h"

#include <antinode_engine/FocusPlayer.h>

#include <memory>

namespace antinode
{
/** Events in, voltages out: voices with their forces and allocations, fused. */
class PlayerNode : public VoiceNode
{
public:
    PlayerNode (int ceramics, PlayerSettings);

    std::string name() const override { return "Player"; }
    int outputs() const override { return ceramics; }
    void prepare (const NodeFormat&) override;
    void process (const NodeBlock&) override;
    void reset() override;
    FocusVoices& voices() override { return *focusPlayer; }
    const FocusVoices& voices() const override { return *focusPlayer; }

private:
    int ceramics;
    PlayerSettings settings;
    double sampleRate = 0;
    std::unique_ptr<FocusPlayer> focusPlayer;
};
} // namespace antinode
