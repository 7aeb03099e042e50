#pragma once

#include <CLI/CLI.hpp>

namespace antinode
{
/** What a recorded sample of 1 stands for. */
struct SensorOptions
{
    double sensitivity = 0;    // mm/s a volt
    double inputFullScale = 1; // V that a recorded sample of 1 stands for

    /** m/s that a recorded sample of 1 stands for. */
    double velocityOfFullScale() const { return inputFullScale * sensitivity / 1000; }
};

/** Adds them to a sub-command. The struct must live as long as the app. @return the sensitivity's option */
CLI::Option* addSensorOptions (CLI::App&, SensorOptions&);
} // namespace antinode
