#include "Perform.h"

#include "RecordedPasses.h"

#include <antinode_base/NumberText.h>
#include <antinode_documents/DesignFile.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_documents/TrackModels.h>
#include <antinode_engine/LagFilters.h>
#include <antinode_render/PerformedDesign.h>
#include <antinode_reports/WaveformsReport.h>
#include <antinode_text/OutputFolder.h>
#include <antinode_text/WaveFile.h>
#include <antinode_text/WaveReader.h>

#include <nlohmann/json.hpp>

namespace antinode
{
namespace
{
/** The waveform of each finger as a sound: full scale is the largest displacement of all. */
void writeFingers (OutputFolder& folder, const PerformedWaveforms& performed)
{
    const auto& played = performed.played;
    const auto loudest = played.displacements.cwiseAbs().maxCoeff();

    for (Eigen::Index p = 0; p < played.displacements.rows(); ++p)
        folder.write (formatted ("finger-%02td.wav", p + 1),
                      encodeWave (played.displacements.row (p), loudest, played.sampleRate));
}

/** What the voltages of a file do, 1.0 of which is the device's full scale. */
PerformedWaveforms judgePlayed (const std::filesystem::path& file, const ModalModel& known, const ModalModel& judge,
                                const WaveformsDescription& description, TrackSettings settings,
                                const ShowProgress& show)
{
    const auto wave = readWaveFile (file);
    settings.sampleRate = wave.sampleRate;
    const Eigen::MatrixXd asked = judge.fullScaleVoltage * wave.samples;
    auto performed =
        judgeVoltages (known, judge, description, settings, withLags (judge, asked, wave.sampleRate), show);

    if (needsLagFilters (judge))
        performed.undone = UndoneLags { asked }; // The samples of the file stay.

    return performed;
}
} // namespace

std::vector<Field> fields (PerformRequest& request)
{
    constexpr double milliseconds = 1000;
    std::vector<Field> all {
        Field ("waveforms", &request.waveforms, "Waveforms: an embedded name or a .json file")
            .usually ("three-fingers")
            .positional(),
        Field ("--device", &request.device, "Device: an embedded name or a .json file")
            .usually ("glass-148x210")
            .by ("the one that the waveforms name, else glass-148x210")
            .positional(),
        Field ("--rate", &request.sampleRate, "Sample rate, Hz").as ("sample_rate_Hz").within (1000, 2e6),
        Field ("--latency-ms", &request.latency,
               "Voltages follow the tracks as live inputs, by filters with this latency, ms, for example 5")
            .in (milliseconds)
            .within (0.1, 100)
            .by ("the whole event is known"),
        Field ("--threshold", &request.thresholdFile, "Threshold of skin: CSV of Hz and um").by ("the built-in table"),
        Field ("--correct", &request.passes,
               "Folder of an earlier pass with recorded.csv or recorded.wav in it (repeatable, in order)")
            .as ("passes")
            .written ("FOLDER")
            .without ("--latency-ms"),
        Field ("--longest-latency-ms", &request.longestLatency,
               "Longest latency of each recording in the search, ms; 0: it begins with its voltages")
            .in (milliseconds)
            .within (0, 200)
            .with ("--correct"),
        cacheField (request.usesCache),
    };
    append (all, fields (request.sensor));
    return all;
}

PerformedWaveforms perform (const PerformRequest& request, const ShowProgress& show)
{
    TrackSettings settings;
    settings.sampleRate = request.sampleRate;
    settings.latency = request.latency.value_or (0);
    settings.threshold = findSkinThreshold (request.thresholdFile.string());

    if (show)
        show ("Modes of the device", 0);

    const auto& waveforms = request.waveforms;
    const auto [known, judge] = trackModels (request.device, request.usesCache);

    if (! request.played.empty())
        return judgePlayed (request.played, known, judge, waveforms, settings, show);

    const auto passes = withoutLatency (readRecordedPasses (request.passes, known, waveforms.band, request.sensor),
                                        known, waveforms, request.sampleRate, request.longestLatency);
    return performWaveforms (known, judge, waveforms, settings, show, passes);
}

void writePerformed (const std::filesystem::path& path, const PerformedWaveforms& performed,
                     const PerformedExtras& extras)
{
    OutputFolder folder (path);
    folder.write ("voltages.wav", encodeWave (outputVoltages (performed), performed.judge.fullScaleVoltage,
                                              performed.played.sampleRate));
    writeFingers (folder, performed);

    if (extras.hasReport)
        folder.write ("report.html", renderReport (waveformsReport (performed)));

    if (extras.designFor != nullptr)
        folder.write ("design.json",
                      designToJson (performedDesign (performed, *extras.designFor), *extras.designFor).dump() + "\n");

    folder.write ("summary.json", performedToJson (performed).dump (2) + "\n");
    folder.commit();
}
} // namespace antinode
