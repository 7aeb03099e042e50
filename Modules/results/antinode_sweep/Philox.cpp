#include "Philox.h"

namespace antinode
{
std::array<std::uint32_t, 4> philox (std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key)
{
    constexpr int rounds = 10, halfWord = 32;
    constexpr std::uint64_t firstFactor = 0xD2511F53, secondFactor = 0xCD9E8D57;
    constexpr std::uint32_t firstWeyl = 0x9E3779B9, secondWeyl = 0xBB67AE85;

    for (int round = 0; round < rounds; ++round)
    {
        const auto first = firstFactor * counter[0], second = secondFactor * counter[2];
        counter = { static_cast<std::uint32_t> (second >> halfWord) ^ counter[1] ^ key[0],
                    static_cast<std::uint32_t> (second),
                    static_cast<std::uint32_t> (first >> halfWord) ^ counter[3] ^ key[1],
                    static_cast<std::uint32_t> (first) };
        key = { key[0] + firstWeyl, key[1] + secondWeyl };
    }

    return counter;
}

std::uint64_t randomBits (std::uint64_t seed, std::uint64_t index, std::uint32_t stream)
{
    constexpr int halfWord = 32;
    const auto low = [] (std::uint64_t word) { return static_cast<std::uint32_t> (word); };
    const auto high = [] (std::uint64_t word) { return static_cast<std::uint32_t> (word >> halfWord); };
    const auto words = philox ({ low (index), high (index), stream, 0 }, { low (seed), high (seed) });
    return (std::uint64_t { words[0] } << halfWord) | words[1];
}

double randomUniform (std::uint64_t seed, std::uint64_t index, std::uint32_t stream)
{
    constexpr int dropped = 12; // the middle of a step of 2^-52 is exact, and never 0 or 1
    return (static_cast<double> (randomBits (seed, index, stream) >> dropped) + 0.5) * 0x1p-52;
}
} // namespace antinode
