#include "Permutation.h"

#include "Philox.h"

#include <bit>

namespace antinode
{
namespace
{
constexpr std::uint32_t rounds = 4;

/** A permutation of all words of twice so many bits (Luby and Rackoff). */
std::uint64_t ciphered (std::uint64_t word, int halfBits, std::uint64_t seed, std::uint32_t stream)
{
    const auto mask = (std::uint64_t { 1 } << halfBits) - 1;
    auto left = word >> halfBits, right = word & mask;

    for (std::uint32_t round = 0; round < rounds; ++round)
    {
        const auto next = left ^ (randomBits (seed, right, stream * rounds + round) & mask);
        left = right;
        right = next;
    }

    return (left << halfBits) | right;
}
} // namespace

std::uint64_t permuted (std::uint64_t index, std::uint64_t count, std::uint64_t seed, std::uint32_t stream)
{
    if (count <= 1)
        return 0;

    const auto halfBits = (static_cast<int> (std::bit_width (count - 1)) + 1) / 2;

    do
        index = ciphered (index, halfBits, seed, stream);
    while (index >= count);

    return index;
}
} // namespace antinode
