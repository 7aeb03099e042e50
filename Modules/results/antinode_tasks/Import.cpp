#include "Import.h"

#include "DeviceChecks.h"

#include <antinode_base/WholeFile.h>
#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/MeasuredDevice.h>

#include <nlohmann/json.hpp>

#include <map>
#include <utility>

namespace antinode
{
namespace
{
ElementResults readElementFiles (const ImportRequest& request)
{
    constexpr FileKind kind { "results of finite elements", std::uintmax_t { 2048 } << 20 };
    std::vector<ElementResults> results;

    for (const auto& file : request.files)
        results.push_back (readElementResults (readWholeFile (file, kind), file.string()));

    auto merged = mergedResults (std::move (results));
    return request.units == "mm" ? fromMillimetres (std::move (merged)) : merged;
}

ImportSettings toSettings (const ImportRequest& request)
{
    const std::map<std::string, int> axes { { "x", 0 }, { "y", 1 }, { "z", 2 } };
    auto settings = request.settings;
    settings.side.axis = axes.at (request.normal);
    settings.side.isTop = request.side == "top";
    settings.side.flatness = request.flatness.value_or (0);
    settings.boundary = boundaryFrom (request.outline);
    settings.fullScaleVoltage = request.fullScaleVoltage.value_or (settings.voltageLimit);
    return settings;
}
} // namespace

std::vector<Field> fields (ImportRequest& request)
{
    constexpr double millimetres = 1000;
    auto& settings = request.settings;
    return {
        Field ("files", &request.files, "CalculiX .frd and .dat files, or universal files").required().positional(),
        Field ("--name", &settings.name, "Name of the device"),
        Field ("--units", &request.units, "Units of the files: SI (m, kg, N, s) or mm (mm, t, N, s)")
            .oneOf ({ "SI", "mm" }),
        Field ("--normal", &request.normal, "Axis that is normal to the surface").oneOf ({ "x", "y", "z" }),
        Field ("--side", &request.side, "Which plane is touched: the highest along that axis, or the lowest")
            .oneOf ({ "top", "bottom" }),
        Field ("--flatness-mm", &request.flatness, "Largest distance of nodes of the surface from its plane, mm")
            .in (millimetres)
            .positive()
            .by ("a thousandth of its extent"),
        outlineField (request.outline),
        Field ("--points", &settings.side.maximumPoints, "Largest number of points; more nodes are thinned evenly")
            .within (3, 20000),
        Field ("--case-voltage-v", &settings.caseVoltage, "Voltage at which the ceramics of the static cases strain, V")
            .as ("case_voltage_V")
            .positive(),
        Field ("--damping-ratio", &settings.dampingRatio, "Damping ratio of modes without one in the files")
            .within (1e-6, 0.9),
        Field ("--voltage-limit-v", &settings.voltageLimit, "Voltage limit of every ceramic, V")
            .as ("voltage_limit_V")
            .positive(),
        Field ("--full-scale-v", &request.fullScaleVoltage, "Voltage of a sample of 1, V")
            .as ("full_scale_V")
            .positive()
            .by ("the voltage limit"),
    };
}

ImportedDevice importDevice (const ImportRequest& request, const ShowProgress&)
{
    return importDevice (readElementFiles (request), toSettings (request));
}

std::string importedDeviceText (const ImportedDevice& device)
{
    return deviceText (modalDeviceToJson (device.model, "Imported from results of finite elements"));
}
} // namespace antinode
