#pragma once

#include "Learn.h"

#include <antinode_engine/LagFilters.h>
#include <antinode_learning/LearningPasses.h>
#include <antinode_reports/Report.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace antinode
{
/** What was recorded while a pass was played: voltages.wav and recorded.wav or recorded.csv of its folder.
    @param sensors  how many channels or columns must be there
    @return         without noise and delay; voltages are those that ceramics acted on
    @throws InputError  for what is missing, cannot be read or does not fit
    [worker] Docs/FileFormats.md. */
PlayedRecording readPlayedRecording (const std::filesystem::path& folder, const ModalModel&, Eigen::Index sensors,
                                     const SensorScale&);

/** What is to be played from now on, with lags of ceramics undone. @throws InputError  as lagFilters [worker] */
UndoneLags learntOutputs (const LearntFocus&, const LearningSettings&);

/** Each sensor's noise by its signal-to-noise ratio in dB: standard deviations of its samples. [any] */
Eigen::VectorXd noiseOfRecording (const Eigen::MatrixXd& signals, double signalToNoise);

/** What is played from now on where what was learnt is refused, before the reason: a sentence and a blank. [any] */
std::string keptInWords (const LearntFocus&);

/** summary.json of what was learnt. [any] Docs/FileFormats.md. */
nlohmann::ordered_json learntToJson (const LearntFocus&);

/** The file of the device as it was learnt. [worker] Docs/FileFormats.md. */
std::string learntDeviceText (const LearntDevice&);

/** Writes what is to be played next and what was learnt: voltages.wav, design.json, device.json, learnt.csv,
    summary.json and report.html.
    @throws InputError  when the folder cannot be written
    [worker] Docs/FileFormats.md. */
void writeLearnt (const std::filesystem::path& folder, const LearntDevice&);

/** The report of passes of learning: the field error of each, what was learnt of each mode with the deviations before
   and after, and what the data could not tell.
    @param nominal  as it was before
    @param before   what was known then [any] */
ReportPage learningReport (const LearntFocus&, const WideModel& nominal, const ModeSpread& before);
} // namespace antinode
