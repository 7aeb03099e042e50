#include "ImportFiles.h"

#include "BoundaryOption.h"

#include <antinode_base/WholeFile.h>
#include <antinode_documents/ChangedDevice.h>
#include <antinode_documents/DeviceFile.h>

#include <nlohmann/json.hpp>

#include <map>
#include <utility>

namespace antinode
{
namespace
{
ElementResults readElementFiles (const ImportOptions& options)
{
    constexpr FileKind kind { "results of finite elements", std::uintmax_t { 2048 } << 20 };
    std::vector<ElementResults> results;

    for (const auto& file : options.files)
        results.push_back (readElementResults (readWholeFile (file, kind), file));

    auto merged = mergedResults (std::move (results));
    return options.units == "mm" ? fromMillimetres (std::move (merged)) : merged;
}

ImportSettings toSettings (const ImportOptions& options)
{
    const std::map<std::string, int> axes { { "x", 0 }, { "y", 1 }, { "z", 2 } };
    auto settings = options.settings;
    settings.side.axis = axes.at (options.normal);
    settings.side.isTop = options.side == "top";
    settings.side.flatness = options.flatness / 1000;
    settings.boundary = boundaryFrom (options.outline);
    settings.fullScaleVoltage = options.fullScaleVoltage.value_or (settings.voltageLimit);
    return settings;
}
} // namespace

ImportedDevice importFiles (const ImportOptions& options)
{
    return importDevice (readElementFiles (options), toSettings (options));
}

std::string importedDeviceText (const ImportedDevice& device)
{
    return deviceText (modalDeviceToJson (device.model, "Imported from results of finite elements"));
}
} // namespace antinode
