#include "MeasurementReader.h"

#include "CsvResponses.h"
#include "MatlabFile.h"
#include "MatlabResponses.h"
#include "UniversalFile.h"
#include "UniversalResponses.h"

#include <antinode_base/InputError.h>
#include <antinode_base/WholeFile.h>
#include <antinode_text/WaveFile.h>

#include <algorithm>
#include <array>

namespace antinode
{
namespace
{
MeasurementFile measurementFromWave (std::string_view bytes, const std::string& source)
{
    const auto wave = decodeWave (bytes, source);
    MeasurementFile file;

    if (wave.samples.cols() < 2)
        throw InputError (source, "has fewer than two samples");

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

/** Names of point and reference from a file's name, where it has words for them. */
void nameByFile (const std::string& source, MeasurementFile& file)
{
    const auto heading = rolesInFileName (source);

    for (auto& response : file.responses)
    {
        response.reference = response.reference.empty() ? heading.reference : response.reference;

        if (file.responses.size() == 1 && response.point.empty())
            response.point = heading.point;
    }
}

MeasurementFile decodeForm (std::string_view bytes, const std::string& source, CsvForm form,
                            const std::vector<std::string>& variables)
{
    switch (measurementForm (bytes))
    {
        case MeasurementForm::wave:
            return measurementFromWave (bytes, source);
        case MeasurementForm::matlab:
            return measurementFromMatlab (readMatlabFile (bytes, source), source, form, variables);
        case MeasurementForm::universal:
            return measurementFromUniversal (readUniversalFile (bytes, source), source);
        case MeasurementForm::text:
            break;
    }

    return measurementFromCsv (bytes, source, form);
}
} // namespace

MeasurementFile decodeMeasurement (std::string_view bytes, const std::string& source, CsvForm form,
                                   const std::vector<std::string>& variables)
{
    auto file = decodeForm (bytes, source, form, variables);
    nameByFile (source, file);
    return file;
}

MeasurementFile readMeasurement (const std::filesystem::path& path, CsvForm form,
                                 const std::vector<std::string>& variables)
{
    constexpr FileKind measurement { "a measurement", std::uintmax_t { 4 } << 30, "cannot be read" };
    return decodeMeasurement (readWholeFile (path, measurement), path.filename().string(), form, variables);
}

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
           || bytes.substr (0, 128).ends_with ("MI") || isMatlabLevel4 (bytes);
}

/** Words like P3, point12, c1. */
bool isNumberedRole (const std::string& word)
{
    constexpr std::array<std::string_view, 7> roles { "p", "point", "node", "c", "d", "ceramic", "driver" };
    const auto letters = word.substr (0, word.find_first_of ("0123456789"));
    return letters.size() < word.size() && std::find (roles.begin(), roles.end(), letters) != roles.end();
}
} // namespace

MeasurementForm measurementForm (std::string_view bytes)
{
    for (const std::string_view mark : { "RIFF", "RF64", "BW64", "RIFX", "riff", "fLaC", "OggS", "caff" })
        if (bytes.starts_with (mark)) // What of these is not read, the reader of WAV files names.
            return MeasurementForm::wave;

    return isMatlab (bytes)      ? MeasurementForm::matlab
           : isUniversal (bytes) ? MeasurementForm::universal
                                 : MeasurementForm::text;
}

CsvHeading rolesInFileName (const std::string& source)
{
    std::string roles;

    for (const auto& word : splitWords (source.substr (0, source.rfind ('.'))))
        roles += isNumberedRole (word) ? word + " " : "";

    return csvHeading (roles);
}
} // namespace antinode
