#pragma once

#include "DetuningSpread.h"

namespace antinode
{
/** What a design is to be robust against, and at what price. Docs/Theory.md, section 7.5. */
struct Robustness
{
    DetuningSpread spread = usualSpread;
    double weight = 1000; ///< An expected error as large as all that is wanted costs so many times the least energy.
};
} // namespace antinode
