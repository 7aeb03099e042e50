#include "PartFolder.h"

#include <Eigen/Core>
#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/System.h>
#include <antinode_base/Watch.h>
#include <antinode_base/WholeFile.h>
#include <antinode_documents/FieldStream.h>
#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <numeric>
#include <random>
#include <system_error>

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

namespace
{
namespace fs = std::filesystem;

constexpr std::string_view temporaryPrefix = ".part-";
constexpr auto partExtension = ".part";
constexpr std::uintmax_t largestPartFile = std::uintmax_t { 1 } << 30;

[[noreturn]] void fail (const fs::path& path, const std::string& wrong)
{
    throw InputError (printable (path.string(), 300), wrong);
}

/** What dead processes of this computer have left. */
void removeAbandonedParts (const fs::path& folder)
{
    std::error_code ignored;
    const auto start = std::string (temporaryPrefix) + computerName() + "-";
    std::vector<fs::path> abandoned;

    for (const auto& entry : fs::directory_iterator (folder, ignored))
    {
        const auto name = entry.path().filename().string();
        int process = 0;

        if (! name.starts_with (start))
            continue;

        const auto* const end = name.data() + name.size();
        const auto parsed = std::from_chars (name.data() + start.size(), end, process);

        if (parsed.ec == std::errc() && parsed.ptr != end && *parsed.ptr == '-' && process > 0
            && ! isProcessRunning (process))
            abandoned.push_back (entry.path());
    }

    for (const auto& path : abandoned)
        fs::remove (path, ignored);
}

/** A name that no other process has, on no computer. */
std::string temporaryName()
{
    std::random_device random;
    return std::string (temporaryPrefix) + computerName() + "-" + std::to_string (ownProcess()) + "-"
           + std::to_string (random());
}
} // namespace

// OutputFolder would remove what processes of other computers write.
void writeAtomically (const fs::path& path, std::string_view content)
{
    const auto temporary = path.parent_path() / temporaryName();
    errno = 0;
    std::ofstream file (temporary, std::ios::binary);
    file.write (content.data(), static_cast<std::streamsize> (content.size()));
    file.close();
    std::error_code error;

    if (! file)
    {
        const std::string reason = std::strerror (errno);
        fs::remove (temporary, error);
        fail (path, "cannot be written: " + reason);
    }

    fs::rename (temporary, path, error);

    // Another process may have tidied up, since the same file is there.
    if (std::error_code unknown; error && ! fs::exists (path, unknown))
        fail (path, "cannot be written: " + error.message());
}

SweepShard readShard (const std::string& text)
{
    SweepShard shard;
    const auto* const end = text.data() + text.size();
    const auto first = std::from_chars (text.data(), end, shard.index);
    const auto hasSlash = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
    const auto second = std::from_chars (hasSlash ? first.ptr + 1 : end, end, shard.count);
    constexpr std::uint64_t most = 1'000'000;

    if (! hasSlash || second.ec != std::errc() || second.ptr != end || shard.count > most || shard.index < 1
        || shard.index > shard.count)
        throw InputError ("--shard", "is " + inQuotes (text) + "; allowed: I/N with I from 1 to N, for example 3/7");

    return shard;
}

PartFolder::PartFolder (const std::filesystem::path& path, const std::string& hashToUse, std::uint64_t cases)
    : folder (path), hash (hashToUse), all (sweepParts (cases))
{
    std::error_code error;

    if (path.empty() || (fs::exists (path, error) && ! fs::is_directory (path, error)))
        fail (path, "is not a folder; allowed: the name of a folder");

    fs::create_directories (folder / "parts", error);

    if (std::error_code unknown; ! fs::is_directory (folder / "parts", unknown))
        fail (folder, "cannot be created: " + error.message());

    removeAbandonedParts (folder);
    removeAbandonedParts (folder / "parts");
}

std::filesystem::path PartFolder::pathOf (std::size_t part) const
{
    return folder / "parts" / formatted ("%08zu%s", part, partExtension);
}

std::vector<std::size_t> PartFolder::missing (SweepShard shard) const
{
    std::vector<std::size_t> indices;
    std::error_code error;

    for (std::size_t i = shard.index - 1; i < all.size(); i += shard.count)
    {
        checkWatch();

        if (! fs::exists (pathOf (i), error))
        {
            indices.push_back (i);
            continue;
        }

        // A damaged part is computed again; one of another plan is somebody's.
        try
        {
            if (decodePart (readWholeFile (pathOf (i), { "a part", largestPartFile })).hash == hash)
                continue;
        }
        catch (const InputError&)
        {
            indices.push_back (i);
            continue;
        }

        fail (pathOf (i), "belongs to another plan; remove it, or choose another folder");
    }

    return indices;
}

std::size_t PartFolder::written() const
{
    std::error_code ignored;
    std::size_t count = 0;

    for (const auto& entry : fs::directory_iterator (folder / "parts", ignored))
        count += entry.path().extension() == partExtension ? 1 : 0;

    return count;
}

std::uint64_t PartFolder::casesOf (const std::vector<std::size_t>& some) const
{
    return std::transform_reduce (some.begin(), some.end(), std::uint64_t { 0 }, std::plus<>(),
                                  [&] (std::size_t part) { return all[part].count; });
}

void PartFolder::write (std::size_t part, const std::vector<CaseResult>& results) const
{
    writeAtomically (pathOf (part), encodePart (hash, all[part].first, results));
}

std::vector<CaseResult> PartFolder::read (std::size_t part) const
{
    const auto path = pathOf (part);
    DecodedPart decoded;

    try
    {
        decoded = decodePart (readWholeFile (path, { "a part", largestPartFile }));
    }
    catch (const InputError&)
    {
        fail (path, "is missing or damaged; run the sweep again, which computes it alone");
    }

    if (decoded.hash != hash)
        fail (path, "belongs to another plan; remove it, or choose another folder");

    if (decoded.first != all[part].first || decoded.results.size() != all[part].count)
        fail (path, "holds other cases than its name says; remove it and run the sweep again");

    return std::move (decoded.results);
}

void PartFolder::keep (std::size_t part, std::string_view bytes) const
{
    const auto decoded = decodePart (bytes);

    if (decoded.hash != hash || decoded.first != all[part].first || decoded.results.size() != all[part].count)
        throw InputError (
            "part " + std::to_string (part),
            "is of another plan, or was computed by another version; allowed: this plan and this version");

    writeAtomically (pathOf (part), bytes);
}

void PartFolder::tidy() const
{
    std::error_code ignored;
    std::vector<fs::path> left;

    for (const auto& where : { folder, folder / "parts" })
        for (const auto& entry : fs::directory_iterator (where, ignored))
            if (entry.path().filename().string().starts_with (temporaryPrefix))
                left.push_back (entry.path());

    for (const auto& path : left)
        fs::remove (path, ignored);
}

std::vector<CaseResult> computePart (const EvaluateCase& evaluate, SweepPart part, const std::function<void()>& done)
{
    std::vector<CaseResult> results;

    for (std::uint64_t i = 0; i < part.count; ++i)
    {
        checkWatch();
        results.push_back (evaluate (part.first + i));
        done();
    }

    return results;
}

void computeParts (const EvaluateCase& evaluate, const PartFolder& folder, const std::vector<std::size_t>& parts,
                   std::size_t threads, const ShowCases& show)
{
    CaseCounter counter (show);
    const auto compute = [&] (std::size_t index)
    { folder.write (parts[index], computePart (evaluate, folder.parts()[parts[index]], [&] { counter.add(); })); };
    parallelFor (parts.size(), compute, threads);
}

PartFolder sweepFolder (const std::filesystem::path& path, const SweepInputs& inputs)
{
    std::error_code error;
    const auto plan = path / "plan.json";

    if (! path.empty() && std::filesystem::exists (plan, error) && loadSweep (plan).hash != inputs.hash)
        throw InputError (printable (path.string(), 300), "holds parts of another plan, or of another version of the "
                                                          "program; choose another folder");

    PartFolder folder (path, inputs.hash, inputs.plan.cases);

    if (! std::filesystem::exists (plan, error))
        writeAtomically (plan, inputs.document.dump (2) + "\n");

    return folder;
}
} // namespace antinode
