#pragma once

namespace antinode
{
/** The scale of recorded samples. */
struct SensorScale
{
    double sensitivity = 0;    ///< mm/s per V; 0: unknown.
    double inputFullScale = 1; ///< Input voltage of a recorded sample of 1, V.

    /** The velocity of a recorded sample of 1, m/s. */
    double fullScaleVelocity() const { return inputFullScale * sensitivity / 1000; }
};
} // namespace antinode
