#include "MeasurementReader.h"

#include "CsvHeading.h"
#include "ImpulseSpectrum.h"
#include "MatlabResponses.h"
#include "UniversalResponses.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/WholeFile.h>
#include <antinode_text/WaveReader.h>
#include <antinode_universal/UniversalFile.h>

#include <algorithm>
#include <array>

namespace antinode
{
namespace
{
bool isUniversal (std::string_view bytes)
{
    constexpr std::size_t preamble = 4096;
    const auto begin = bytes.substr (0, preamble);
    return begin.starts_with ("    -1") || begin.find ("\n    -1") != std::string_view::npos;
}

bool isMatlab (std::string_view bytes)
{
    return bytes.starts_with ("MATLAB") || bytes.starts_with ("\x89HDF") || bytes.substr (0, 128).ends_with ("IM")
           || bytes.substr (0, 128).ends_with ("MI");
}

MeasurementFile measurementFromWave (std::string_view bytes, const std::string& source)
{
    const auto wave = decodeWave (bytes, source);
    MeasurementFile file;

    if (wave.samples.cols() < 2)
        throw InputError (source, "has less than two samples");

    for (const auto& channel : wave.samples.rowwise())
    {
        const auto spectrum = impulseSpectrum (channel.transpose(), 1 / wave.sampleRate);
        file.responses.push_back ({ source,
                                    {},
                                    {},
                                    {},
                                    {},
                                    sharedFrequencies (spectrum.frequencies, file.responses),
                                    spectrum.values,
                                    spectrum.recordLength });
    }

    file.remarks.push_back (source + ": the channels are read as impulse responses.");
    return file;
}

/** Words like P3, point12, c1. */
bool isNumberedRole (const std::string& word)
{
    constexpr std::array<std::string_view, 7> roles { "p", "point", "node", "c", "d", "ceramic", "driver" };
    const auto letters = word.substr (0, word.find_first_of ("0123456789"));
    return letters.size() < word.size() && std::find (roles.begin(), roles.end(), letters) != roles.end();
}

/** Names of point and reference from a file's name, where it has words for them: "point3_driver2", "P3-C1". */
void nameByFile (const std::string& stem, MeasurementFile& file)
{
    std::string roles;

    for (const auto& word : splitWords (stem))
        roles += isNumberedRole (word) ? word + " " : "";

    const auto heading = csvHeading (roles);

    for (auto& response : file.responses)
    {
        response.reference = response.reference.empty() ? heading.reference : response.reference;

        if (file.responses.size() == 1 && response.point.empty())
            response.point = heading.point;
    }
}
} // namespace

MeasurementFile decodeMeasurement (std::string_view bytes, const std::string& source, CsvForm form)
{
    auto file = bytes.starts_with ("RIFF") || bytes.starts_with ("RF64") ? measurementFromWave (bytes, source)
                : isMatlab (bytes)    ? measurementFromMatlab (readMatlabFile (bytes, source), source)
                : isUniversal (bytes) ? measurementFromUniversal (readUniversalFile (bytes, source), source)
                                      : measurementFromCsv (bytes, source, form);
    nameByFile (source.substr (0, source.rfind ('.')), file);
    return file;
}

MeasurementFile readMeasurement (const std::filesystem::path& path, CsvForm form)
{
    constexpr FileKind measurement { "a measurement", std::uintmax_t { 4 } << 30, "cannot be read" };
    return decodeMeasurement (readWholeFile (path, measurement), path.filename().string(), form);
}
} // namespace antinode
