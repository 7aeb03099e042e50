#pragma once

#include <array>
#include <cstddef>

namespace antinode
{
/** How many fingers have an input of their own. */
inline constexpr int mostFingers = 8;

/** What a finger is to the design. */
enum class FingerPresence
{
    absent, ///< Nowhere: it is not designed for.
    silent, ///< It rests and is to feel nothing.
    plays   ///< It rests and is to feel its input.
};

/** What a finger is to the surface, by the names of the built-in ones. */
enum class FingerLoad
{
    none,
    light,
    medium,
    firm
};

/** What kinds of loads are called; none: empty. */
inline constexpr std::array fingerLoadWords { "", "light", "medium", "firm" };

/** A finger as the parameters of a host say it. */
struct FingerSettings
{
    float xPercent = 50, yPercent = 50; ///< Of the surface's extent.
    FingerPresence presence = FingerPresence::absent;
    FingerLoad load = FingerLoad::none;

    bool operator== (const FingerSettings&) const = default;
};

/** The latencies that can be chosen, s: the longer, the fewer volts. */
inline constexpr std::array touchLatencies { 0.02, 0.01, 0.005 };

/** All that filters depend on, beside the device and the rate. */
struct TouchSettings
{
    std::array<FingerSettings, mostFingers> fingers {};
    std::size_t latency = 0; ///< Index in touchLatencies.

    bool operator== (const TouchSettings&) const = default;
};
} // namespace antinode
