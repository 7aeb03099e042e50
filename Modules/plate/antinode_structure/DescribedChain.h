#pragma once

#include "ElementChain.h"

namespace antinode
{
/** A described beam as a chain of its bare and covered stretches, from left to right. [any] Docs/Theory.md,
    section 1.3. */
ElementChain makeChain (const BeamDescription&);

/** A described staple as a chain: the left leg upwards, the top from left to right, the right leg downwards.
    [any] Docs/Theory.md, section 1.3. */
ElementChain makeChain (const StapleDescription&);
} // namespace antinode
