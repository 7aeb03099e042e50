#pragma once

#include "FingerTrace.h"
#include "PeakMeters.h"

#include <array>
#include <atomic>
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

/** What takes effect at once. */
struct TouchControls
{
    bool isArmed = true;                       ///< False: all voltages ramp to 0.
    std::array<double, mostFingers> levels {}; ///< m that 1.0 of an input moves its finger; 0: silent.
    double focusGain = 1;                      ///< Factor of the foci that begin from now on, 0 to 1.
    std::size_t latency = 0;                   ///< Index in touchLatencies: by how much foci wait for the filters.
    NoteMeaning notes = NoteMeaning::nothing;  ///< Set by the session, as the next line.
    bool stops = false;                        ///< Foci that play or wait end before the block's notes.
};

/** Levels of the audio thread for other threads. */
struct FingerMeters
{
    PeakMeters<mostFingers> inputs;              ///< Of full scale.
    PeakMeters<mostFingers> displacements;       ///< m within the band: what is asked for.
    PeakMeters<mostFingers> felt;                ///< Times the threshold of skin.
    std::array<FingerTrace, mostFingers> traces; ///< m within the band, sample by sample of the filters.
    std::atomic<double> traceRate { 0 };         ///< Hz, of the traces; 0 before anything plays.
};
} // namespace antinode
