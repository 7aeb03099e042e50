#pragma once

#include <antinode_render/RenderedFocus.h>
#include <antinode_text/OutputFolder.h>

#include <string>

namespace antinode
{
/** Writes the voltages and the probe velocities of a rendered focus: voltages.wav and probe.wav, with format "csv"
   voltages.csv instead, with "tfw" one voltages-NN.tfw a ceramic and their settings in voltages-tfw.csv; probe.csv
   always. 1.0 in voltages.wav is the full scale of the device, in probe.wav 1 m/s.
    @throws InputError  when a format cannot hold the samples
    [worker] Docs/FileFormats.md. */
void writeSamples (OutputFolder&, const RenderedFocus&, const std::string& format);
} // namespace antinode
