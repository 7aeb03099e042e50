#include "ModeCacheEntry.h"

#include "ModelFields.h"

#include <xxhash.h>

#include <algorithm>

namespace antinode
{
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
