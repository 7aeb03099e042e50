#include "MeasurementReader.h"

#include "ImpulseSpectrum.h"
#include "MatlabResponses.h"
#include "MeasurementForm.h"
#include "UniversalResponses.h"

#include "UniversalFile.h"
#include <antinode_base/InputError.h>
#include <antinode_base/WholeFile.h>
#include <antinode_text/WaveReader.h>

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
} // namespace antinode
