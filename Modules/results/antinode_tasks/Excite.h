#pragma once

#include "Field.h"

#include <antinode_base/Progress.h>
#include <antinode_documents/ExcitationFile.h>
#include <antinode_model/ModalModel.h>
#include <antinode_structure/DeviceDescription.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
inline constexpr TaskText exciteText { "excite",
                                       "Writes the excitation of the ceramics for a measurement of the surface",
                                       "Docs/Theory.md, section 8.8" };

/** A device and its excitation. What is missing is chosen for the device's modes: the band from half the lowest mode to
    20 kHz, the highest mode or 0.45 of the rate, four lines in the narrowest half-power width, settling until 1e-5 of
   the slowest mode is left, a fifth of the limits. */
struct ExcitationRequest
{
    DeviceDescription device;
    bool usesCache = true;
    std::string signal = "multisine";
    double sampleRate = 96000;                         ///< Hz
    std::optional<double> lowest, highest, resolution; ///< Hz
    int periods = 4;
    std::optional<int> settling;
    double sweepDuration = 4; ///< s
    bool hasOddLines = false;
    int seed = 1;
    std::vector<double> levels; ///< V, of each ceramic, or one for all.
};

/** [any] */
std::vector<Field> fields (ExcitationRequest&);

/** A solved device. @throws InputError  where it cannot be solved, and without ceramics or modes [worker] */
ModalModel excitedModel (const DeviceDescription&, bool usesCache);

/** The excitation of a solved device.
    @throws InputError  as makeExcitation, or unless there is one level or one per ceramic [worker] */
ExcitationSheet excitationFor (const ModalModel&, const ExcitationRequest&);

/** The excitation of a device. @throws InputError  as excitedModel and excitationFor [worker] */
ExcitationSheet excite (const ExcitationRequest&, const ShowProgress&);

/** All runs of an excitation, one after the other: (N_b + 1) x samples of full scale, ceramics, then the sync channel.
    @throws InputError  where they are too long to be kept [worker] */
Eigen::MatrixXd playedRuns (const ExcitationSheet&);

/** Writes excitation.wav, excitation.json and signal.wav.
    @throws InputError  as playedRuns, and when the folder cannot be written
    [worker] Docs/FileFormats.md. */
void writeExcitation (const std::filesystem::path& folder, const ExcitationSheet&);
} // namespace antinode
