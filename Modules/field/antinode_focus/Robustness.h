#pragma once

#include "DetuningSpread.h"

namespace antinode
{
/** The errors that a design is robust against, and their weight. Docs/Theory.md, section 7.5. */
struct Robustness
{
    DetuningSpread spread = usualSpread;
    double weight =
        1000; ///< The cost of an expected error as large as the wanted velocities, as a multiple of the least energy.
};
} // namespace antinode
