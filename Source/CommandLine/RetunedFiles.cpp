#include "RetunedFiles.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_library/Library.h>
#include <antinode_responses/MeasurementReader.h>

#include <nlohmann/json.hpp>

#include <utility>

namespace antinode
{
RetunedDevice retuneByFiles (const DeviceDescription& device, const std::vector<std::string>& names, bool usesCache)
{
    auto model = solveDevice (device, {}, usesCache);
    std::vector<MeasurementFile> files;
    files.reserve (names.size());

    for (const auto& name : names)
        files.push_back (readMeasurement (name, CsvForm::byHeadings));

    auto retuned = retune (model, mergedResponses (files, {}).responses, {});
    return { std::move (model), std::move (retuned) };
}

std::string retunedDeviceText (const RetunedModel& retuned)
{
    return modalDeviceToJson (retuned.model, "Retuned from a few points").dump (2) + "\n";
}
} // namespace antinode
