#pragma once

#include <antinode_render/FocusOutcome.h>
#include <antinode_text/OutputFolder.h>

#include <filesystem>
#include <string>
#include <vector>

namespace antinode
{
/** Which files of a render are wanted. */
struct RenderedFiles
{
    std::string format = "wav"; ///< Of the voltages: "wav", "csv", "mat", "tfw".
    bool hasReport = true;
    std::vector<std::string> figures; ///< "svg", "pdf": those of the report for print.
};

/** Writes the voltages and the probe velocities of a rendered focus: voltages.wav and probe.wav, with format "csv"
   voltages.csv instead, with "mat" voltages.mat, with "tfw" one voltages-NN.tfw a ceramic and their settings in
   voltages-tfw.csv; probe.csv always. 1.0 in voltages.wav is the full scale of the device, in probe.wav 1 m/s.
    @throws InputError  when a format cannot hold the samples
    [worker] Docs/FileFormats.md. */
void writeSamples (OutputFolder&, const RenderedFocus&, const std::string& format);

/** Writes all files of a rendered focus into a folder, which is made where it is missing.
    @throws InputError  as writeSamples, or when the folder cannot be written
    [worker] Docs/FileFormats.md. */
void writeRendered (const std::filesystem::path&, const RenderedFocus&, const FocusOutcome&, const RenderedFiles&);
} // namespace antinode
