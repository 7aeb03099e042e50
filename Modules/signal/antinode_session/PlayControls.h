#pragma once

#include "TouchSettings.h"

#include <antinode_engine/FocusVoices.h>

#include <array>
#include <cstddef>

namespace antinode
{
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
