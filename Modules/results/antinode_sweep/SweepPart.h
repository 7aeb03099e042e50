#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** What became of a case. */
struct CaseResult
{
    std::vector<double> values; ///< Of all columns; NaN where there is none.
    std::string error;          ///< Why there are none; empty where there are.
};

/** Cases that follow each other, which are computed and kept together. */
struct SweepPart
{
    std::uint64_t first = 0, count = 0;
};

/** Of bytes and the version of the program: 32 hexadecimal digits. [worker] */
std::string hashOf (std::string bytes);

/** A few cases to many, so that there are some 500 parts and a part is at most 10 000 cases. They depend on the number
   of cases alone, whoever computes them. [any] */
std::vector<SweepPart> sweepParts (std::uint64_t cases);

/** The results of a part, as bytes. @param hash  of all that the cases depend on [worker] */
std::string encodePart (const std::string& hash, std::uint64_t first, const std::vector<CaseResult>&);

/** What a part's bytes hold. */
struct DecodedPart
{
    std::string hash;
    std::uint64_t first = 0;
    std::vector<CaseResult> results;
};

/** Reads what encodePart gave, from bytes of anybody.
    @throws InputError  when they are damaged
    [worker] */
DecodedPart decodePart (std::string_view bytes);
} // namespace antinode
