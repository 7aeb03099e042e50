#pragma once

namespace antinode::bench
{
/** Prints our own solver's time, gap and limit violation on all kinds of instances up to a size (1 to 6), as a table.
 */
void printOwnTable (int largestSize);
} // namespace antinode::bench
