#pragma once

namespace antinode
{
/** The number of Gauss's and Legendre's places that represent a wave of a phase, rad, over their segment to 3e-5 of its
   amplitude. [any] Docs/Theory.md, section 1.5. */
int placesForPhase (double phase, int fewest);
} // namespace antinode
