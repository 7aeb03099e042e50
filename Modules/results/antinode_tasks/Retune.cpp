#include "Retune.h"

#include <antinode_documents/Library.h>
#include <antinode_documents/MeasuredDevice.h>
#include <antinode_identification/Wiring.h>
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

std::vector<Field> fields (RetuneRequest& request)
{
    constexpr double percent = 100, millimetres = 1000;
    const auto deviation = [&] (const char* option, double& value, const char* of)
    { return Field (option, &value, std::string ("Standard deviation of ") + of).in (percent).within (0.01, 50); };
    return {
        Field ("device", &request.device, "Device before the drift: an embedded name or a .json file")
            .required()
            .positional(),
        Field ("files", &request.files, "Frequency responses of a few points, as written by frf and measure")
            .required()
            .positional(),
        deviation ("--frequency-percent", request.spread.frequency, "each frequency from the device, %"),
        deviation ("--drift-percent", request.spread.drift, "the factor common to all frequencies, %"),
        deviation ("--damping-percent", request.spread.damping, "each damping ratio, %"),
        deviation ("--participation-percent", request.spread.participation,
                   "each participation, in addition to a factor of each ceramic, %"),
        Field ("--place-mm", &request.placeDeviation, "Standard deviation of each point's place along x and y, mm")
            .in (millimetres)
            .within (0, 50),
        cacheField (request.usesCache),
    };
}

RetunedDevice retune (const RetuneRequest& request, const ShowProgress&)
{
    auto model = solveDevice (request.device, {}, request.usesCache);
    auto measured = responsesOfFiles ({ request.files.begin(), request.files.end() });

    if (measured.responses.drive == DriveQuantity::force) // As identify makes a device of such.
    {
        measured.responses.drive = DriveQuantity::voltage;
        measured.remarks.emplace_back ("Forces excite the surface: 1 N counts as 1 V of the device.");
    }

    for (const auto& found : checkWiring (model, measured.responses))
        measured.remarks.push_back (wireInWords (found));

    auto retuned = retune (model, measured.responses, request.spread, request.placeDeviation);

    if (retuned.hasExactShapes && request.placeDeviation > 0)
        measured.remarks.emplace_back (
            "Shapes and places of the points are assumed exact: they are fitted only if the device records where its "
            "modes come from, at up to 30 points, with up to 4000 unknowns (modes times ceramics and points).");

    return { request.device, std::move (model), std::move (retuned), std::move (measured.remarks) };
}

std::string retunedDeviceText (const RetunedDevice& retuned)
{
    return changedDeviceText (retuned.device, retuned.before, retuned.now.model, "Retuned from a few points");
}
} // namespace antinode
