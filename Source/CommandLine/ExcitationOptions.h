#pragma once

#include <antinode_documents/ExcitationFolder.h>
#include <antinode_model/ModalModel.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The common options of excite and measure: a device and its excitation. What is missing is chosen for
    the device's modes. */
struct ExcitationOptions
{
    std::string device;
    std::vector<std::string> assignments;
    bool usesCache = true;
    std::string signal = "multisine";
    double rate = 96000; // Hz
    std::optional<double> lowest, highest, resolution;
    int periods = 4;
    std::optional<int> settling;
    double sweepDuration = 4; // s
    bool hasOddLines = false;
    int seed = 1;
    std::vector<double> levels; // V, of each ceramic, or one for all
};

/** Adds them to a sub-command. The struct must live as long as the app. */
void addExcitationOptions (CLI::App&, ExcitationOptions&);

/** The solved device that the options name. @throws InputError  for anything that cannot be read or solved. [worker] */
ModalModel excitedDevice (const ExcitationOptions&);

/** Refuses a device that nothing can be excited on. @throws InputError  without ceramics or modes [any] */
void checkExcitable (const ModalModel&);

/** The excitation that the options ask for. Where they do not say: the band from half the lowest mode to 20 kHz, the
   highest mode or 0.45 of the rate, four lines in the narrowest half-power width, settling until 1e-5 of the slowest
   mode is left, a fifth of the limits.
    @throws InputError  as makeExcitation, or unless there is one level or one per ceramic [worker] */
ExcitationSheet excitationFor (const ModalModel&, const ExcitationOptions&);
} // namespace antinode
