#include "ModeCache.h"

#include "FieldStream.h"

#include <antinode_base/System.h>
#include <antinode_base/WholeFile.h>
#include <antinode_structure/DescriptionFields.h>
#include <antinode_structure/MeasuredModel.h>
#include <antinode_structure/OutlinedModel.h>
#include <antinode_structure/StaticShare.h>
#include <antinode_text/OutputFolder.h>
#include <xxhash.h>

#include <algorithm>
#include <vector>

namespace antinode
{
namespace
{
constexpr int cacheFormat = 4; // To be raised when an entry is written in another way.
}

std::optional<std::string> modeCacheKey (const DeviceDescription& device, std::optional<int> modeCount,
                                         SolvedShapes shapes)
{
    if (! isComputed (device))
        return {};

    FieldWriter writer;
    writer (cacheFormat, std::string (ANTINODE_VERSION), std::string (ANTINODE_SOLVER), device.name, modeCount,
            device.body.index());
    std::visit (
        [&] (const auto& body)
        {
            if constexpr (requires { body.common; })
                writer (body);
        },
        device.body);

    if (shapes == SolvedShapes::withStaticShare)
        writer (std::string ("static share"));

    if (shapes == SolvedShapes::onPointsOfFewer)
        writer (std::string ("points of fewer"));

    return std::move (writer.bytes);
}

namespace
{
namespace fs = std::filesystem;

constexpr std::string_view cacheExtension = ".modes";
constexpr std::string_view hexadecimal = "0123456789abcdef";

/** The name of the file for a key. Two keys may share one in principle: the entry holds the whole key. */
std::string nameFor (std::string_view key)
{
    XXH128_canonical_t hash;
    XXH128_canonicalFromHash (&hash, XXH3_128bits (key.data(), key.size()));
    std::string name;

    for (const auto byte : hash.digest)
    {
        name += hexadecimal[byte / 16];
        name += hexadecimal[byte % 16];
    }

    return name.append (cacheExtension);
}

bool isEntryName (const std::string& name)
{
    const auto digits = 2 * sizeof (XXH128_canonical_t);
    return name.size() == digits + cacheExtension.size() && name.ends_with (cacheExtension)
           && name.find_first_not_of (hexadecimal) == digits;
}

void makePrivateFolder (const fs::path& folder)
{
    if (fs::create_directories (folder))
        fs::permissions (folder, fs::perms::owner_all);
}

ModalModel solved (const DeviceDescription& device, std::optional<int> modeCount, SolvedShapes shapes)
{
    switch (shapes)
    {
        case SolvedShapes::withStaticShare:
            return solveWithStaticShare (device, modeCount);
        case SolvedShapes::onPointsOfFewer:
            return solveOutlinedOnPointsOfFewer (device.name, std::get<OutlinedPlate> (device.body), modeCount.value());
        case SolvedShapes::modes:
            break;
    }

    return solveStructure (device, modeCount);
}

struct StoredFile
{
    fs::file_time_type lastUse;
    fs::path path;
    std::uintmax_t size = 0;

    bool operator<(const StoredFile& other) const
    {
        return lastUse != other.lastUse ? lastUse < other.lastUse : path < other.path;
    }
};

std::vector<StoredFile> entriesIn (const fs::path& folder)
{
    std::vector<StoredFile> files;
    std::error_code error;

    for (fs::directory_iterator entry (folder, error), end; ! error && entry != end; entry.increment (error))
    {
        if (! isEntryName (entry->path().filename().string()))
            continue;

        std::error_code gone; // Another process may remove it at any time; a folder has no size.
        const auto lastUse = entry->last_write_time (gone);

        if (const auto size = gone ? 0 : entry->file_size (gone); ! gone)
            files.push_back ({ lastUse, entry->path(), size });
    }

    return files;
}
} // namespace

ModeCache::ModeCache (std::filesystem::path folderToUse, std::uintmax_t maximumBytesToUse)
    : folder (std::move (folderToUse)), maximumBytes (maximumBytesToUse)
{
}

std::optional<ModalModel> ModeCache::find (const DeviceDescription& device, std::optional<int> modeCount,
                                           SolvedShapes shapes) const
{
    const auto key = modeCacheKey (device, modeCount, shapes);

    if (! key)
        return {};

    removeAbandoned (folder);

    try
    {
        const auto path = folder / nameFor (*key);
        auto model = decodeModeCacheEntry (readWholeFile (path, { "a file", maximumBytes }), *key);
        std::error_code ignored;
        fs::last_write_time (path, fs::file_time_type::clock::now(), ignored);
        return model;
    }
    catch (const std::exception&)
    {
        return {}; // Missing, damaged, foreign, or too large for this machine: solved again.
    }
}

void ModeCache::store (const DeviceDescription& device, std::optional<int> modeCount, const ModalModel& model,
                       SolvedShapes shapes) const
{
    const auto key = modeCacheKey (device, modeCount, shapes);

    if (! key)
        return;

    try
    {
        const auto bytes = encodeModeCacheEntry (*key, model);

        if (bytes.size() > maximumBytes)
            return;

        makePrivateFolder (folder);
        const auto name = nameFor (*key);
        OutputFolder output (folder);
        output.write (name, bytes);
        fs::permissions (output.pathFor (name), fs::perms::owner_read | fs::perms::owner_write);
        output.commit();
        removeOldest();
    }
    catch (const std::exception&)
    {
        return; // The modes are there all the same; the next run solves them again.
    }
}

void ModeCache::removeOldest() const
{
    auto files = entriesIn (folder);
    std::sort (files.begin(), files.end());
    std::uintmax_t total = 0;

    for (const auto& file : files)
        total += file.size;

    for (const auto& file : files)
    {
        if (total <= maximumBytes)
            return;

        std::error_code ignored;
        fs::remove (file.path, ignored);
        total -= file.size;
    }
}

std::optional<std::filesystem::path> userCacheFolder()
{
    const auto home = userCacheHome();
    return home ? std::optional (*home / "antinode" / "modes") : std::nullopt;
}

ModalModel solveCached (const DeviceDescription& device, std::optional<int> modeCount, const ModeCache* cache,
                        SolvedShapes shapes)
{
    if (const auto* const measured = std::get_if<MeasuredDevice> (&device.body))
    {
        const auto hasShare = shapes == SolvedShapes::withStaticShare && hasStaticShare (device);
        const auto drawn = solveCached (*measured->drawing, {}, cache, hasShare ? shapes : SolvedShapes::modes);
        return measuredModel (*measured, drawn, hasShare ? drawn.actuators() : 0);
    }

    if (cache != nullptr)
        if (auto found = cache->find (device, modeCount, shapes))
            return *std::move (found);

    auto model = solved (device, modeCount, shapes);

    if (cache != nullptr)
        cache->store (device, modeCount, model, shapes);

    return model;
}

namespace
{
constexpr std::string_view magic = "ANTIMODE";
constexpr auto checksumSize = sizeof (XXH64_hash_t);

void require (bool fulfilled, const std::string& wrong)
{
    if (! fulfilled)
        throw InputError ("entry of the mode cache", wrong);
}

std::uint64_t computeChecksum (std::string_view bytes)
{
    return XXH3_64bits (bytes.data(), bytes.size());
}

bool isAscending (const auto& values)
{
    return std::is_sorted (values.begin(), values.end());
}

/** Interpolation indexes by these numbers. */
bool isSound (const GridAxis& axis)
{
    const auto segments = axis.first.size() - 1;
    return segments > 0 && axis.first[0] == 0 && axis.first[segments] == axis.places.size() && isAscending (axis.first)
           && axis.edges.size() == segments + 1 && axis.weights.size() == axis.places.size() && isAscending (axis.edges)
           && isAscending (axis.places);
}

/** What validate() leaves to who makes a model. */
void checkParts (const ModalModel& model)
{
    const auto& shapes = model.shapes;
    const auto& slopes = model.slopes;
    require (slopes.size() == 0 || (slopes.rows() == shapes.rows() && slopes.cols() == shapes.cols()),
             "has slopes whose size differs from its shapes");
    require (model.frequencyErrors.size() == 0 || model.frequencyErrors.size() == model.modes(),
             "has error estimates for some modes only");
    require (model.fullScaleVoltage > 0 && model.rigidBodyModes >= 0 && model.unknowns >= 0,
             "has a negative number where none is possible");

    if (const auto& grid = model.surface.grid)
        require (isSound (grid->x) && isSound (grid->y), "has an inconsistent grid");
}
} // namespace

std::string encodeModeCacheEntry (std::string_view key, const ModalModel& model)
{
    FieldWriter writer;
    // Nearly all of an entry are its shapes and slopes; growing by doubling would copy them again and again.
    writer.bytes.reserve (static_cast<std::size_t> (model.shapes.size() + model.slopes.size()) * sizeof (double)
                          + static_cast<std::size_t> (model.points() + model.modes()) * 16 * sizeof (double) + 65536);
    writer.bytes = magic;
    const auto placeOfSize = writer.bytes.size();
    writer (std::uint64_t (0), std::string (key), model);

    const std::uint64_t size = writer.bytes.size() + checksumSize;
    std::memcpy (writer.bytes.data() + placeOfSize, &size, sizeof (size));
    writer (computeChecksum (writer.bytes));
    return std::move (writer.bytes);
}

ModalModel decodeModeCacheEntry (std::string_view bytes, std::string_view key)
{
    require (bytes.size() > magic.size() + checksumSize && bytes.substr (0, magic.size()) == magic,
             "is not a cache entry");
    const auto content = bytes.substr (0, bytes.size() - checksumSize);
    std::uint64_t size = 0, checksum = 0;
    FieldReader (bytes.substr (content.size())) (checksum);
    require (checksum == computeChecksum (content), "is damaged");

    FieldReader reader (content.substr (magic.size()));
    std::string storedKey;
    reader (size, storedKey);
    require (size == bytes.size(), "has a length that differs from its header");
    require (storedKey == key, "belongs to another device");

    ModalModel model;
    reader (model);
    require (reader.isAtEnd(), "contains data after the model");
    validate (model);
    checkParts (model);
    return model;
}
} // namespace antinode
