#include "VoiceNode.h"

#include <algorithm>
#include <functional>

namespace antinode
{
PlayerNode::PlayerNode (int ceramicsToUse, PlayerSettings settingsToUse)
    : ceramics (ceramicsToUse), settings (settingsToUse)
{
}

void PlayerNode::prepare (const NodeFormat& format)
{
    if (focusPlayer != nullptr && format.sampleRate == sampleRate)
        return;

    focusPlayer = std::make_unique<FocusPlayer> (ceramics, format.sampleRate, settings);
    sampleRate = format.sampleRate;
}

void PlayerNode::process (const NodeBlock& block)
{
    focusPlayer->process (block.outputs, block.count, block.events);
}

void PlayerNode::reset()
{
    focusPlayer->reset();
}

void OverlaidFociNode::process (const NodeBlock& block)
{
    PlayerNode::process (block);

    for (int i = 0; i < outputs(); ++i)
        std::transform (block.inputs[i], block.inputs[i] + block.count, block.outputs[i], block.outputs[i],
                        std::plus<>());
}

ForceNode::ForceNode (int ceramicsToUse, PlayerSettings settingsToUse, int channelsToUse)
    : ceramics (ceramicsToUse), channels (channelsToUse), settings (settingsToUse)
{
}

void ForceNode::prepare (const NodeFormat& format)
{
    if (player != nullptr && format.sampleRate == sampleRate)
        return;

    player = std::make_unique<ForcePlayer> (ceramics, format.sampleRate, settings, channels);
    sampleRate = format.sampleRate;
}

void ForceNode::process (const NodeBlock& block)
{
    player->process (block.outputs, block.count, block.events);
}

void ForceNode::reset()
{
    player->reset();
}

AllocationNode::AllocationNode (const ForceNode& forcesToUse, int ceramicsToUse)
    : forces (forcesToUse), ceramics (ceramicsToUse)
{
}

/** Samples are voltages of the ceramics already. */
void AllocationNode::addVoltages (const ForceStretch& stretch, const NodeBlock& block) const
{
    for (int i = 0; i < ceramics; ++i)
        for (int n = stretch.from; n < stretch.to; ++n)
            block.outputs[i][n] += block.inputs[stretch.first + i][n];
}

void AllocationNode::process (const NodeBlock& block)
{
    for (int i = 0; i < ceramics; ++i)
        std::fill_n (block.outputs[i], block.count, 0.0);

    for (const auto& stretch : forces.stretches())
        if (stretch.design != nullptr)
            stretch.design->mix (block.inputs + stretch.first, stretch.from, stretch.to, block.outputs);
        else
            addVoltages (stretch, block);
}
} // namespace antinode
