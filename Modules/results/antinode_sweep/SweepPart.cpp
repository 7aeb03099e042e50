#include "SweepPart.h"

#include <antinode_base/InputError.h>
#include <antinode_documents/FieldStream.h>

#include <Eigen/Core>
#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace antinode
{
namespace
{
constexpr std::string_view magic = "ANTISWP1";
constexpr std::uint64_t usualParts = 500, largestPart = 10'000;

/** Numbers as they lie in memory: NaN stands for what a case does not have. */
using Bits = Eigen::Matrix<std::uint64_t, Eigen::Dynamic, Eigen::Dynamic>;

std::uint64_t checksum (std::string_view bytes)
{
    return XXH3_64bits (bytes.data(), bytes.size());
}
} // namespace

std::string hashOf (std::string bytes)
{
    bytes += "\n" ANTINODE_VERSION;
    const auto hash = XXH3_128bits (bytes.data(), bytes.size());
    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash (&canonical, hash);
    std::string text;

    for (const auto byte : canonical.digest)
    {
        constexpr auto digits = "0123456789abcdef";
        text += digits[byte >> 4];
        text += digits[byte & 15];
    }

    return text;
}

std::vector<SweepPart> sweepParts (std::uint64_t cases)
{
    const auto size = std::clamp<std::uint64_t> (cases / usualParts, 1, largestPart);
    std::vector<SweepPart> parts;

    for (std::uint64_t first = 0; first < cases; first += size)
        parts.push_back ({ first, std::min (size, cases - first) });

    return parts;
}

std::string encodePart (const std::string& hash, std::uint64_t first, const std::vector<CaseResult>& results)
{
    const auto columns = results.empty() ? 0 : results.front().values.size();
    Bits bits (static_cast<Eigen::Index> (results.size()), static_cast<Eigen::Index> (columns));
    std::vector<std::string> errors;

    for (Eigen::Index i = 0; i < bits.rows(); ++i)
    {
        const auto& result = results[static_cast<std::size_t> (i)];
        errors.push_back (result.error);

        for (Eigen::Index j = 0; j < bits.cols(); ++j)
            bits (i, j) = std::bit_cast<std::uint64_t> (result.values[static_cast<std::size_t> (j)]);
    }

    FieldWriter writer;
    writer (std::string (magic), hash, first, bits, errors);
    const auto sum = checksum (writer.bytes);
    writer (sum);
    return std::move (writer.bytes);
}

DecodedPart decodePart (std::string_view bytes)
{
    const auto fail = [] { throw InputError ("part", "is damaged"); };
    std::uint64_t sum = 0;

    if (bytes.size() < sizeof (sum))
        fail();

    const auto content = bytes.substr (0, bytes.size() - sizeof (sum));
    std::memcpy (&sum, bytes.data() + content.size(), sizeof (sum));

    if (sum != checksum (content))
        fail();

    FieldReader reader (content);
    std::string begin;
    DecodedPart part;
    Bits bits;
    std::vector<std::string> errors;
    reader (begin, part.hash, part.first, bits, errors);

    if (begin != magic || ! reader.isAtEnd() || errors.size() != static_cast<std::size_t> (bits.rows()))
        fail();

    for (Eigen::Index i = 0; i < bits.rows(); ++i)
    {
        auto& result = part.results.emplace_back();
        result.error = std::move (errors[static_cast<std::size_t> (i)]);

        for (Eigen::Index j = 0; j < bits.cols(); ++j)
            result.values.push_back (std::bit_cast<double> (bits (i, j)));
    }

    return part;
}
} // namespace antinode
