#pragma once

#include <cstdint>
#include <span>

namespace antinode
{
/** The index of the first sample of any channel that is not finite, from an offset on, or `count`. [audio thread] */
int firstBadSample (std::span<const float* const> channels, int offset, int count);

/** Copies samples clamped to what an output can play: finite, and within full scale. @param clamped  grows by those
   that were beyond it [audio thread] */
void copyWithin (const float* from, float* to, int count, double factor, std::int64_t& clamped);

/** The largest magnitude. [audio thread] */
float absolutePeak (const float* samples, int count);
} // namespace antinode
