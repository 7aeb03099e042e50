#pragma once

#include "DrawnDevices.h"
#include "Field.h"
#include "RecordedSignals.h"
#include "TracksAt.h"

#include <antinode_base/Progress.h>
#include <antinode_documents/Library.h>
#include <antinode_model/ModalModel.h>
#include <antinode_render/PerformedWaveforms.h>
#include <antinode_render/PlayedTracks.h>
#include <antinode_structure/DeviceDescription.h>

#include <filesystem>
#include <optional>
#include <string>
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
    TracksAt at;
    double sampleRate = 48000;                 ///< Hz
    std::optional<double> latency;             ///< s, of live inputs; none: the whole event is known.
    std::filesystem::path thresholdFile;       ///< What skin feels; empty: the built-in table.
    std::vector<std::filesystem::path> passes; ///< Folders of earlier passes, in their order.
    double longestLatency = 0;                 ///< s, of recordings; 0: they begin with their voltages.
    SensorScale sensor;
    std::filesystem::path played; ///< Voltages that were recorded elsewhere are judged; empty: they are designed.
    bool hasTolerance = false;    ///< Whether the voltages are played on devices that deviate, too:
    DrawnDevices devices;
    bool usesCache = true;
};

/** [any] */
std::vector<Field> fields (PerformRequest&);

/** Waveforms as strong as the limits of a device allow. */
struct ReachedWaveforms
{
    PerformedWaveforms performed;
    double share = 1; ///< Of their levels; less where the limits allow no more.
};

/** Designs and plays waveforms: at their levels, or at the share of these that the limits allow.
    @throws InputError  as performWaveforms [worker] */
ReachedWaveforms performWithinLimits (const TrackModels&, WaveformsDescription, const TrackSettings&);

/** @throws InputError, LimitError  as placedWaveforms, performWaveforms and readRecordedPasses [worker] */
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

/** Passes that were played and recorded: from each folder voltages.wav and summary.json of antinode perform and what
   was recorded meanwhile, recorded.csv (headings with _um or _mm_s) or recorded.wav (velocities).
    @throws InputError  for what is missing or cannot be read, and recorded.wav without a sensitivity
    [worker] Docs/FileFormats.md. */
std::vector<RecordedPass> readRecordedPasses (const std::vector<std::filesystem::path>& folders, const ModalModel&,
                                              TrackBand, const SensorScale&);

/** The same passes without the latency of their recordings, each its own, found by what the model expects of the
    voltages.
    @param sampleRate      Hz, of the next design
    @param longestLatency  s, that is looked for; 0: as they are
    @throws InputError  as requirePasses and predictedDisplacements, and for a recording that is silent
    [worker] Docs/Theory.md, section 4.15. */
std::vector<RecordedPass> withoutLatency (std::vector<RecordedPass>, const ModalModel& known,
                                          const WaveformsDescription&, double sampleRate, double longestLatency);
} // namespace antinode
