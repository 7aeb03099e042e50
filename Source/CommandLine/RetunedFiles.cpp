#include "RetunedFiles.h"

#include <antinode_documents/ChangedDevice.h>
#include <antinode_library/Library.h>
#include <antinode_responses/MeasurementReader.h>
#include <antinode_text/NaturalOrder.h>

#include <utility>

namespace antinode
{
Measurement responsesOfFiles (const std::vector<std::string>& names)
{
    std::vector<MeasurementFile> files;
    files.reserve (names.size());

    for (const auto& name : inNaturalOrder (names))
        files.push_back (readMeasurement (name, CsvForm::byHeadings));

    return mergedResponses (files, {});
}

RetunedDevice retuneByFiles (const DeviceDescription& device, const std::vector<std::string>& names,
                             const RetuneDeviations& deviations, bool usesCache)
{
    constexpr double percent = 0.01, millimetre = 1e-3;
    const KnownSpread spread { percent * deviations.frequency, percent * deviations.damping,
                               percent * deviations.participation, percent * deviations.drift };
    auto model = solveDevice (device, {}, usesCache);
    auto measured = responsesOfFiles (names);

    if (measured.responses.drive == DriveQuantity::force) // As identify makes a device of such.
    {
        measured.responses.drive = DriveQuantity::voltage;
        measured.remarks.emplace_back ("Forces excite the surface: 1 N counts as 1 V of the device.");
    }

    auto retuned = retune (model, measured.responses, spread, millimetre * deviations.place);

    if (retuned.hasExactShapes && deviations.place > 0)
        measured.remarks.emplace_back ("Shapes and places of the points are taken as exact: they are fitted where the "
                                       "device says where its modes come from, at up to 30 points, of up to 4000 "
                                       "unknowns (modes times ceramics and points).");

    return { device, std::move (model), std::move (retuned), std::move (measured.remarks) };
}

std::string retunedDeviceText (const RetunedDevice& retuned)
{
    return changedDeviceText (retuned.device, retuned.before, retuned.now.model, "Retuned from a few points");
}
} // namespace antinode
