#pragma once

#include <antinode_outline/OutlineChecks.h>

#include <cstdint>

namespace antinode::test
{
/** An outline, and ceramics on it, with one fault; what they were before, and words of the sentence that is due. */
struct BrokenOutline
{
    std::string fault; ///< Its kind, for messages.
    Outline outline, whole;
    std::vector<OutlinePart> parts, wholeParts;
    std::string words;
};

/** So many, of every kind of fault in turn, from a seed. */
std::vector<BrokenOutline> brokenOutlines (int count, std::uint32_t seed);
} // namespace antinode::test
