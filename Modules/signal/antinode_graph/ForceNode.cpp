#include "ForceNode.h"

namespace antinode
{
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
} // namespace antinode
