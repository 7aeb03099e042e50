#include "PlayerNode.h"

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
} // namespace antinode
