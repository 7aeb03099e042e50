#pragma once

#include "Node.h"

#include <antinode_engine/FocusVoices.h>

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
} // namespace antinode
