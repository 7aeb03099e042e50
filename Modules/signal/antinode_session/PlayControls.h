#pragma once

#include <antinode_engine/FocusPlayer.h>

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

/** What notes play. */
enum class NoteMeaning
{
    nothing,
    spread,  ///< Each note the focus at a place of its own.
    spotOnly ///< All notes the focus at its own place.
};

/** What of an instrument takes effect immediately, without a new design. */
struct PlayControls
{
    PlayerSettings notes = {};                 ///< What notes do.
    bool isArmed = true;                       ///< False: all voltages ramp to 0.
    double outputTrim = 1;                     ///< Factor of all voltages, 0 to 1.
    double monitorGain = 1;                    ///< Factor of the probe velocities; 1: a sample of 1.0 is 1 m/s.
    double voltageLimit = 1e9;                 ///< V, in addition to each ceramic's own limit.
    unsigned long long mutes = 0;              ///< Bit i: ceramic i + 1 is silent.
    std::array<double, mostFingers> levels {}; ///< m that 1.0 of an input moves its finger; 0: silent.
    double focusGain = 1;                      ///< Factor of the foci that begin from now on, 0 to 1.
    std::size_t latency = 0;                   ///< Index in touchLatencies: by how much foci wait for the filters.
};
} // namespace antinode
