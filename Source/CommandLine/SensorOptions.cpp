#include "SensorOptions.h"

namespace antinode
{
CLI::Option* addSensorOptions (CLI::App& command, SensorOptions& options)
{
    constexpr double minimum = 1e-9, maximum = 1e9;
    command.add_option ("--input-full-scale-v", options.inputFullScale, "Input voltage of a recorded sample of 1, V")
        ->check (CLI::Range (minimum, maximum))
        ->capture_default_str();
    return command
        .add_option ("--sensitivity-mm-s-per-v", options.sensitivity, "Sensitivity of the sensor, mm/s per V")
        ->check (CLI::Range (minimum, maximum));
}
} // namespace antinode
