#include "ExcitationFolder.h"

#include <antinode_text/JsonText.h>
#include <antinode_text/WaveFile.h>
#include <antinode_text/WaveReader.h>

namespace antinode
{
namespace
{
constexpr const char* signalFile = "signal.wav";
} // namespace

void writeSheet (OutputFolder& folder, const ExcitationSheet& sheet)
{
    folder.write (signalFile,
                  encodeWave (sheet.excitation.signal.transpose(), 1, sheet.excitation.settings.sampleRate));
    folder.write ("excitation.json", excitationToJson (sheet, signalFile).dump (2) + "\n");
}

ExcitationSheet readSheet (const std::filesystem::path& path)
{
    const auto source = path.string();
    const auto document = readJsonFile (path);
    const auto signal = readWaveFile (path.parent_path() / readSignalFileName (document, source));
    return readExcitation (document, source, signal.samples.row (0));
}
} // namespace antinode
