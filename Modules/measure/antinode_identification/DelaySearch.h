#pragma once

#include <functional>

namespace antinode
{
/** The delay that scores highest, from -3 to 3 ms. Among many delays a few modes agree on a wrong one by chance: a long
    one must be better than a short one.
    @param score    of a delay in s, smooth
    @param highest  rad/s, of the modes
    @param price    of a long delay, in units of the score
    @return         s; the smallest where several do
    [worker] Docs/Theory.md, section 8.4. */
double searchDelay (const std::function<double (double)>& score, double highest, double price);
} // namespace antinode
