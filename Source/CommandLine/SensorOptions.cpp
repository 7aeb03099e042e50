#include "SensorOptions.h"

namespace antinode
{
CLI::Option* addSensorOptions (CLI::App& command, SensorOptions& options)
{
    constexpr double least = 1e-9, most = 1e9;
    command
        .add_option ("--input-full-scale-v", options.inputFullScale,
                     "Voltage at an input, V, that a recorded sample of 1 stands for")
        ->check (CLI::Range (least, most))
        ->capture_default_str();
    return command
        .add_option ("--sensitivity-mm-s-per-v", options.sensitivity,
                     "Velocity for which the sensor gives a volt, mm/s")
        ->check (CLI::Range (least, most));
}
} // namespace antinode
