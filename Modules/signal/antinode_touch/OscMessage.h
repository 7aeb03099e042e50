#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace antinode
{
struct OscNil
{
};

struct OscInfinitum
{
};

/** Seconds since 1900, with 32 binary places; 1 = at once. */
struct OscTimeTag
{
    std::uint64_t value = 1;
};

/** The types i f s b h d T F N I t. */
using OscArgument = std::variant<std::int32_t, float, std::string, std::vector<std::byte>, std::int64_t, double, bool,
                                 OscNil, OscInfinitum, OscTimeTag>;

struct OscMessage
{
    std::string address; ///< Starts with '/'.
    std::vector<OscArgument> arguments;
};

/** An argument of the types i f h d as a number; may be not finite. [any] */
std::optional<double> toNumber (const OscArgument&);
} // namespace antinode
