#pragma once

#include <antinode_measurement/Excitation.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace antinode
{
/** An excitation and its purpose: all that `frf` needs to evaluate recordings of it. */
struct ExcitationSheet
{
    std::string device;                ///< Its name.
    std::vector<std::string> ceramics; ///< N_b names, in the order of their runs.
    Eigen::VectorXd voltageLimits;     ///< N_b: V
    double fullScaleVoltage = 1;       ///< The voltage of a sample of 1, V.
    Excitation excitation;
};

/** Schema antinode.excitation/1: settings, order, lengths, and the name of the file that holds the signal of a run.
    @param signalFile   in the folder of the sheet
    [worker] Docs/FileFormats.md. */
nlohmann::ordered_json excitationToJson (const ExcitationSheet&, const std::string& signalFile);

/** The name of the file with the signal. @throws InputError  as readExcitation [worker] */
std::string readSignalFileName (const nlohmann::json&, const std::string& source);

/** A sheet from its JSON and the signal of a run.
    @param signal  as the file in the folder of the sheet has it, peak 1
    @throws InputError  source, JSON pointer, what is wrong, what is allowed, "did you mean"; or where the signal does
   not fit [worker] */
ExcitationSheet readExcitation (const nlohmann::json&, const std::string& source, const Eigen::VectorXd& signal);

/** Writes the sheet and the signal of a run into a folder, as excitation.json and signal.wav. @throws InputError
    [worker] */
void writeSheet (OutputFolder&, const ExcitationSheet&);

/** A sheet with the signal beside it. @throws InputError  for anything that cannot be read. [worker] */
ExcitationSheet readSheet (const std::filesystem::path&);
} // namespace antinode
