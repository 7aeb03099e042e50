#pragma once

#include <CLI/CLI.hpp>

namespace antinode
{
/** The scale of recorded samples. */
struct SensorOptions
{
    double sensitivity = 0;    // mm/s per V
    double inputFullScale = 1; // The voltage of a recorded sample of 1, V

    /** The velocity of a recorded sample of 1, m/s. */
    double fullScaleVelocity() const { return inputFullScale * sensitivity / 1000; }
};

/** Adds them to a sub-command. The struct must live as long as the app. @return the sensitivity's option */
CLI::Option* addSensorOptions (CLI::App&, SensorOptions&);
} // namespace antinode
