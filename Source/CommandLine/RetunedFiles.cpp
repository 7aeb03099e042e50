#include "RetunedFiles.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_library/Library.h>
#include <antinode_responses/MeasurementReader.h>

#include <nlohmann/json.hpp>

#include <utility>

namespace antinode
{
FrequencyResponses responsesOfFiles (const std::vector<std::string>& names)
{
    std::vector<MeasurementFile> files;
    files.reserve (names.size());

    for (const auto& name : names)
        files.push_back (readMeasurement (name, CsvForm::byHeadings));

    return mergedResponses (files, {}).responses;
}

RetunedDevice retuneByFiles (const DeviceDescription& device, const std::vector<std::string>& names,
                             const RetuneDeviations& deviations, bool usesCache)
{
    constexpr double percent = 0.01;
    const KnownSpread spread { percent * deviations.frequency, percent * deviations.damping,
                               percent * deviations.participation, percent * deviations.drift };
    auto model = solveDevice (device, {}, usesCache);
    auto retuned = retune (model, responsesOfFiles (names), spread);
    return { std::move (model), std::move (retuned) };
}

std::string retunedDeviceText (const RetunedModel& retuned)
{
    return modalDeviceToJson (retuned.model, "Retuned from a few points").dump (2) + "\n";
}
} // namespace antinode
