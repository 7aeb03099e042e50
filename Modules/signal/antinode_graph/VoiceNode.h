#pragma once

#include "Node.h"

#include <antinode_engine/FocusPlayer.h>
#include <antinode_engine/ForcePlayer.h>

#include <memory>

namespace antinode
{
/** A node that plays foci: where a path begins. */
class VoiceNode : public Node
{
public:
    int inputs() const override { return 0; }
    std::int64_t latencySamples() const override { return voices().latencySamples(); }

    /** Its voices, which take banks. Those of the last prepare: new ones are made whenever the rate changes.
        [worker, not while it processes; the getters of FocusVoices as they say] */
    virtual FocusVoices& voices() = 0;
    virtual const FocusVoices& voices() const = 0;
};

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

/** Foci on top of other voltages: what comes in, with the voltages of the voices added. */
class OverlaidFociNode : public PlayerNode
{
public:
    using PlayerNode::PlayerNode;

    std::string name() const override { return "Foci on top"; }
    int inputs() const override { return outputs(); }
    void process (const NodeBlock&) override;
};

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
