#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace antinode
{
/** A product of powers of units: its size in SI units and the exponents of metre, second, newton and volt. */
struct PhysicalUnit
{
    double factor = 1;
    std::array<int, 4> exponents {};
};

/** A unit as people and programs write it, with products, quotients, powers and brackets; a number may begin it. Metric
   prefixes, names in full, plurals and capitals are known, and the units of vibration in inches, pounds and multiples
   of gravity: "m/s^2", "in/sec^2", "g's", "mg", "Gal", "ips", "lbf", "kgf", "(m/s^2)/N", "um V^-1". Empty where a part
   of it is no unit of length, time, force or voltage. [any] */
std::optional<PhysicalUnit> physicalUnit (std::string_view text);
} // namespace antinode
