#pragma once

#include <cstdint>

namespace antinode
{
/** Where a random permutation of 0 to count - 1 puts one index, without the others: a cipher of four rounds, repeated
   until its result is below the count.
    @param index   below count
    @param count   at least 1, at most 2^62
    @param stream  which permutation of the seed
    [any] J. Black and P. Rogaway, Ciphers with arbitrary finite domains, CT-RSA 2002. */
std::uint64_t permuted (std::uint64_t index, std::uint64_t count, std::uint64_t seed, std::uint32_t stream);
} // namespace antinode
