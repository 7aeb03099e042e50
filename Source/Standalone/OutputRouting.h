#pragma once

#include <array>
#include <vector>

namespace antinode
{
/** One output: its amplifier and wiring. */
struct OutputChain
{
    double voltsPerFullScale = 0; ///< V at the ceramic for a sample of 1.0; 0: the device's full scale.
    int polarity = 1;             ///< 1 or -1.

    bool operator== (const OutputChain&) const = default;
};

/** The output of each ceramic: each ceramic has at most one output, each output at most one ceramic. Counted from 0. */
struct OutputRouting
{
    static constexpr int maximumCeramics = 64, maximumOutputs = 128, monitors = 2;
    static constexpr int none = -1;

    std::array<int, maximumCeramics> outputs {};       ///< Of each ceramic; `none`: nothing drives it.
    std::array<OutputChain, maximumOutputs> chains {}; ///< Of each output.
    int monitor = none;                                ///< The first of two outputs with the velocity at the probes.

    bool operator== (const OutputRouting&) const = default;
};

/** Ceramic k on output k, no monitor: an amplifier that got a velocity as a voltage would be a surprise. [any] */
OutputRouting straightRouting();

/** The same with a ceramic on another output, or on none; whatever had that output loses it. [any] */
OutputRouting withOutput (OutputRouting, int ceramic, int output);

/** The same with the monitor on another pair, or on none; whatever had those outputs loses them. [any] */
OutputRouting withMonitor (OutputRouting, int firstOutput);

/** The volts of a full-scale sample at the output of each ceramic; 0: the device's full scale, or no output. [any] */
std::vector<double> amplifierVoltages (const OutputRouting&);

/** @throws InputError  where an output is no output or is used twice, or a chain has a gain or a polarity that is none
    [any] */
void validate (const OutputRouting&);
} // namespace antinode
