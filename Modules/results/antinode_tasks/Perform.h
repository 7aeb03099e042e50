#pragma once

#include "Field.h"
#include "RecordedSignals.h"

#include <antinode_base/ShowProgress.h>
#include <antinode_model/ModalModel.h>
#include <antinode_render/PerformedWaveforms.h>
#include <antinode_structure/DeviceDescription.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace antinode
{
inline constexpr TaskText performText { "perform",
                                        "Gives every finger its own waveform: voltages, the motion at each, a report",
                                        "Docs/Theory.md, sections 4.13 and 5.3" };

/** Waveforms at fingers, and how their voltages are made. */
struct PerformRequest
{
    WaveformsDescription waveforms;
    DeviceDescription device;
    double sampleRate = 48000;                 ///< Hz
    std::optional<double> latency;             ///< s, of live inputs; none: the whole event is known.
    std::filesystem::path thresholdFile;       ///< What skin feels; empty: the built-in table.
    std::vector<std::filesystem::path> passes; ///< Folders of earlier passes, in their order.
    double longestLatency = 0;                 ///< s, of recordings; 0: they begin with their voltages.
    SensorScale sensor;
    std::filesystem::path played; ///< Voltages that were recorded elsewhere are judged; empty: they are designed.
    bool usesCache = true;
};

/** [any] */
std::vector<Field> fields (PerformRequest&);

/** @throws InputError, LimitError  as performWaveforms and readRecordedPasses [worker] */
PerformedWaveforms perform (const PerformRequest&, const ShowProgress&);

/** What is written besides voltages, sounds and numbers. */
struct PerformedExtras
{
    bool hasReport = true;
    const ModalModel* designFor = nullptr; ///< The device's own modes, where a design.json is wanted.
};

/** Writes all files of performed waveforms into a folder, which is made where it is missing.
    @throws InputError  when it cannot be written [worker] Docs/FileFormats.md. */
void writePerformed (const std::filesystem::path&, const PerformedWaveforms&, const PerformedExtras&);
} // namespace antinode
