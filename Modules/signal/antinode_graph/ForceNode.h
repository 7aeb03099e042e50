#pragma once

#include "VoiceNode.h"

#include <antinode_engine/ForcePlayer.h>

#include <memory>

namespace antinode
{
/** Events in, force oscillations out: what drives the modes before an AllocationNode shares it out among ceramics.
    It plays the bank of foci that PlayerNode plays, with all that its voices do; only mixing is left out.
    Docs/Architecture.md, Nodes. */
class ForceNode : public VoiceNode
{
public:
    /** How many oscillations may sound at once: 24 foci of 340 of them. */
    static constexpr int usualChannels = 8192;

    /** @param ceramics  of the foci that it plays
        @param channels  its outputs; ForcePlayer says how voices share them */
    ForceNode (int ceramics, PlayerSettings, int channels = usualChannels);

    std::string name() const override { return "Forces"; }
    int outputs() const override { return channels; }
    void prepare (const NodeFormat&) override;
    void process (const NodeBlock&) override;
    void reset() override;
    FocusVoices& voices() override { return *player; }
    const FocusVoices& voices() const override { return *player; }

    /** Which of the outputs hold something, and how it is shared out; a node behind this one that changes forces
        needs to look at no others. Of the last block. [audio thread] */
    std::span<const ForceStretch> stretches() const { return player->stretches(); }

private:
    int ceramics, channels;
    PlayerSettings settings;
    double sampleRate = 0;
    std::unique_ptr<ForcePlayer> player;
};
} // namespace antinode
