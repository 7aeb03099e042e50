#include "ExcitedFiles.h"

#include <antinode_base/InputError.h>
#include <antinode_documents/ExcitationFolder.h>
#include <antinode_text/WaveFile.h>

namespace antinode
{
Eigen::MatrixXd playedRuns (const ExcitationSheet& sheet)
{
    constexpr double maximumBytes = 512.0 * 1024 * 1024, bytesPerSample = 4;
    const auto& excitation = sheet.excitation;
    const auto ceramics = excitation.ceramics(), samples = ceramics * excitation.runLength;

    if (static_cast<double> (samples) * static_cast<double> (ceramics + 1) * bytesPerSample > maximumBytes)
        throw InputError ("excitation", "would make a file of more than 512 MiB; choose fewer periods, a coarser "
                                        "resolution or a lower rate, or use `antinode measure`, which needs no file");

    Eigen::MatrixXd played (ceramics + 1, samples);

    for (Eigen::Index i = 0; i < ceramics; ++i)
        played.middleCols (i * excitation.runLength, excitation.runLength) =
            playedRun (excitation, i, sheet.fullScaleVoltage);

    return played;
}

void writeExcitation (const std::filesystem::path& path, const ExcitationSheet& sheet)
{
    OutputFolder folder (path);
    folder.write ("excitation.wav", encodeWave (playedRuns (sheet), 1, sheet.excitation.settings.sampleRate));
    writeSheet (folder, sheet);
    folder.commit();
}
} // namespace antinode
