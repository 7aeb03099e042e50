#pragma once

#include <antinode_fingers/Finger.h>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstddef>
#include <string_view>

namespace antinode
{
class JsonObject;
class JsonValue;

/** What files say of a finger besides its place. Docs/FileFormats.md, focus. */
inline constexpr std::array<std::string_view, 7> fingerKeys {
    "kind", "radius_mm", "mass_g", "damping_N_s_per_m", "stiffness_N_per_mm", "known", "pressing_force_N"
};

/** As many as a focus has, at most. */
inline constexpr std::size_t maximumFingers = 10;

/** A built-in finger with what an object says instead.
    @param x, y  m
    @throws InputError  source, place, what is wrong, what is allowed [worker] */
Finger readFinger (const JsonObject&, double x, double y);

/** The same from the name of a built-in finger, or an object of fingerKeys. [worker] */
Finger readFinger (const JsonValue&, double x, double y);

/** A finger with its place, as focus files have it. [worker] */
nlohmann::ordered_json fingerToJson (const Finger&);
} // namespace antinode
