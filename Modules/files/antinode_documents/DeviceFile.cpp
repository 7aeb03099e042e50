#include "DeviceFile.h"

#include "LimitsReader.h"
#include "MeasuredReader.h"
#include "ModalReader.h"
#include "StructureReader.h"
#include "UnlikelyValues.h"

#include <antinode_text/JsonReader.h>
#include <antinode_text/PhysicalRanges.h>

#include <algorithm>
#include <array>
#include <memory>

namespace antinode
{
namespace
{
using DeviceBody = decltype (DeviceDescription::body);

DeviceBody readPlateBody (const JsonValue& device)
{
    return std::visit ([] (auto plate) -> DeviceBody { return plate; }, readPlate (device));
}

DeviceBody readBeamBody (const JsonValue& device)
{
    return readBeam (device);
}

DeviceBody readStapleBody (const JsonValue& device)
{
    return readStaple (device);
}

constexpr WordList<DeviceBody (*) (const JsonValue&), 3> drawnKinds {
    { { "plate", &readPlateBody }, { "beam", &readBeamBody }, { "staple", &readStapleBody } }
};

DeviceBody readMeasuredBody (const JsonValue& device)
{
    readLimits (device.required ("limits")); // What is wrong with them stands here, not in the base that gets them.
    const auto base = device.required ("base");
    DeviceDescription drawing;
    drawing.name = device.required ("name").text (ranges::maximumNameBytes);
    drawing.body = base.required ("kind").choice (drawnKinds) (base);
    return readMeasuredDevice (device, std::make_shared<const DeviceDescription> (std::move (drawing)));
}

constexpr WordList<DeviceBody (*) (const JsonValue&), 4> deviceKinds {
    { { "plate", &readPlateBody },
      { "beam", &readBeamBody },
      { "staple", &readStapleBody },
      { "modal", [] (const JsonValue& device) -> DeviceBody { return readModalModel (device); } } }
};

bool hasBase (const nlohmann::json& document)
{
    return document.is_object() && document.contains ("base") && document["base"].is_object();
}

/** A document whose base is whole: what a base may not say itself is what the device says. */
nlohmann::json withWholeBase (nlohmann::json document, const std::string& source)
{
    for (const auto* const key : { "schema", "name", "description", "limits" })
        if (document["base"].contains (key))
            JsonValue (document, source)
                .required ("base")
                .required (key)
                .fail ("is in the base; allowed: in the device that has the base");

    if (document.contains ("limits"))
        document["base"]["limits"] = document["limits"];

    return document;
}

/** A document without what fills it: modes that are given, and their points. */
nlohmann::json withoutModes (const nlohmann::json& document)
{
    constexpr std::array<std::string_view, 5> large { "modes", "points_mm", "weights_kg", "areas_m2", "exact" };
    nlohmann::json kept;

    for (const auto& [key, value] : document.items())
        if (document.value ("kind", "") != "modal" || std::find (large.begin(), large.end(), key) == large.end())
            kept[key] = value;

    return kept;
}
} // namespace

DeviceDescription readDevice (const nlohmann::json& given, const std::string& source)
{
    const auto whole = hasBase (given) ? withWholeBase (given, source) : nlohmann::json();
    const JsonValue device (whole.is_null() ? given : whole, source);
    device.requireSchema ("antinode.device/1");
    DeviceDescription result;
    result.body =
        device.find ("base") ? readMeasuredBody (device) : device.required ("kind").choice (deviceKinds) (device);
    result.requiresArming = readLimits (device.required ("limits")).requiresArming;
    result.name = device.required ("name").text (ranges::maximumNameBytes);

    if (const auto description = device.find ("description"))
        result.description = description->text (ranges::maximumDescriptionBytes, true);

    if (auto* const model = std::get_if<ModalModel> (&result.body))
        model->name = result.name;

    const auto kept = withoutModes (given);
    result.document = kept.dump();
    result.warnings = unlikelyValues (kept);
    return result;
}
} // namespace antinode
