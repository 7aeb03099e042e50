#include "Support/ErrorText.h"
#include "Support/GridModel.h"
#include "Support/SameModel.h"

#include <antinode_documents/ModeCache.h>

#include <catch2/catch.hpp>

#include <xxhash.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

using namespace antinode;

namespace
{
using namespace std::string_view_literals;

constexpr auto key = "a key\0 with a zero"sv;

/** Entries whose checksum is right: what is wrong in them must be found all the same. */
std::string withChecksum (std::string bytes)
{
    const std::uint64_t size = bytes.size();
    std::memcpy (bytes.data() + 8, &size, sizeof (size));
    const std::uint64_t checksum = XXH3_64bits (bytes.data(), bytes.size() - 8);
    std::memcpy (bytes.data() + bytes.size() - 8, &checksum, sizeof (checksum));
    return bytes;
}

std::string decodeError (std::string_view bytes)
{
    return errorText ([&] { decodeModeCacheEntry (bytes, key); });
}

std::string errorAfter (const std::function<void (ModalModel&)>& change)
{
    auto model = test::gridModel (3, 2, 3);
    change (model);
    return decodeError (encodeModeCacheEntry (key, model));
}
} // namespace

TEST_CASE ("An entry is magic, length, key, model and checksum", "[files][cache]")
{
    const auto model = test::gridModel (3, 2);
    const auto bytes = encodeModeCacheEntry (key, model);
    CHECK (bytes.substr (0, 8) == "ANTIMODE");
    CHECK (withChecksum (bytes) == bytes);
    CHECK (bytes.substr (24, key.size()) == key);
    CHECK (test::isSameToTheBit (decodeModeCacheEntry (bytes, key), model));
    CHECK (errorText ([&] { decodeModeCacheEntry (bytes, "another"); })
           == "entry of the mode cache: belongs to another device");
}

TEST_CASE ("Sizes that an entry claims and has not are found before anything is allocated", "[files][cache]")
{
    const auto good = encodeModeCacheEntry (key, test::gridModel (3, 2, 3));

    // Every eight bytes may be a length; whatever is claimed there, nothing is believed beyond the end of the entry.
    for (const std::uint64_t claim : { std::uint64_t (1) << 20, std::uint64_t (1) << 30, (std::uint64_t (1) << 31) - 1,
                                       std::uint64_t (1) << 40, std::uint64_t (1) << 61, ~std::uint64_t (0) })
        for (std::size_t at = 16; at + 16 <= good.size(); at += at < 1000 ? 1 : 13)
        {
            auto bytes = good;
            std::memcpy (bytes.data() + at, &claim, sizeof (claim));
            decodeError (withChecksum (bytes)); // Any other exception, of an allocation for one, fails the test.
        }

    CHECK (decodeError (withChecksum (good + std::string (8, '\0')))
           == "entry of the mode cache: contains data after the model");
    auto longer = good;
    longer[8] = static_cast<char> (longer[8] + 1);
    const std::uint64_t checksum = XXH3_64bits (longer.data(), longer.size() - 8);
    std::memcpy (longer.data() + longer.size() - 8, &checksum, sizeof (checksum));
    CHECK (decodeError (longer) == "entry of the mode cache: has a length that differs from its header");
}

TEST_CASE ("A model that is not valid is not read, though its entry is whole", "[files][cache]")
{
    constexpr auto nan = std::numeric_limits<double>::quiet_NaN();
    constexpr auto infinite = std::numeric_limits<double>::infinity();
    CHECK (errorAfter ([] (auto&) {}).empty());

    const std::vector<std::function<void (ModalModel&)>> changes {
        [] (auto& m) { m.shapes (2, 1) = nan; },
        [] (auto& m) { m.participation (0, 0) = infinite; },
        [] (auto& m) { m.fullScaleVoltage = nan; },
        [] (auto& m) { m.frequencyErrors[0] = infinite; },
        [] (auto& m) { m.surface.xMaximum = -infinite; },
        [] (auto& m) { m.surface.grid->y.places[1] = nan; },
        [] (auto& m) { m.ceramics[1].voltageLimit = nan; },
        [] (auto& m) { m.dampingRatios[1] = 1; },
        [] (auto& m) { m.angularFrequencies.reverseInPlace(); },
        [] (auto& m) { m.ceramics.pop_back(); },
        [] (auto& m) { m.shapes.conservativeResize (2, 3); },
        [] (auto& m) { m.slopes = m.shapes.topRows (2); },
        [] (auto& m) { m.frequencyErrors.conservativeResize (2); },
        [] (auto& m) { m.fullScaleVoltage = 0; },
        [] (auto& m) { m.rigidBodyModes = -1; },
        [] (auto& m) { m.surface.grid->x.first[1] = 1000000; },
        [] (auto& m) { m.surface.grid->x.first[0] = -1; },
        [] (auto& m) { m.surface.grid->x.first.resize (0); },
        [] (auto& m) { m.surface.grid->y.edges.conservativeResize (2); },
        [] (auto& m) { m.surface.grid->y.weights.conservativeResize (2); },
        [] (auto& m) { m.surface.grid->y.places.reverseInPlace(); },
        [] (auto& m) { m.surface.masses.setZero(); },
    };

    for (std::size_t i = 0; i < changes.size(); ++i)
    {
        INFO ("change " << i);
        CHECK_FALSE (errorAfter (changes[i]).empty());
    }
}
