#include "PerformedFiles.h"

#include <antinode_base/NumberText.h>
#include <antinode_documents/DesignFile.h>
#include <antinode_render/PerformedDesign.h>
#include <antinode_reports/WaveformsReport.h>
#include <antinode_text/OutputFolder.h>
#include <antinode_text/WaveFile.h>

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
} // namespace

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
