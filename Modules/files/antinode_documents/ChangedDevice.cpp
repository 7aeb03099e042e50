#include "ChangedDevice.h"

#include "DeviceFile.h"
#include "MeasuredReader.h"

#include <antinode_base/InputError.h>
#include <antinode_base/WholeFile.h>
#include <antinode_structure/MeasuredModel.h>
#include <antinode_text/JsonText.h>
#include <antinode_text/PhysicalRanges.h>

namespace antinode
{
namespace
{
using Json = nlohmann::ordered_json;

/** Behind what a device's user says of it, in a line of its own; said twice it is there once. */
std::string withChange (const std::string& description, const std::string& change)
{
    if (description.empty() || description == change)
        return change;

    if (description.ends_with ("\n" + change) || description.size() + change.size() >= ranges::maximumDescriptionBytes)
        return description;

    return description + "\n" + change;
}

/** A drawn device, without what stands in the device that it is the base of. */
Json baseOf (Json document)
{
    if (document.contains ("base"))
        return document["base"];

    for (const auto* const key : { "schema", "name", "description", "limits" })
        document.erase (key);

    return document;
}
} // namespace

std::string deviceText (const nlohmann::ordered_json& device)
{
    auto text = readableJson (device);
    const auto name = "device '" + device.value ("name", "") + "'";

    if (const auto most = FileKind {}.maximumBytes; text.size() > most)
        throw InputError (name, "would be a file of " + std::to_string (text.size() >> 20)
                                    + " MiB, which is not read again; allowed: up to " + std::to_string (most >> 20)
                                    + " MiB, with fewer points or modes");

    try
    {
        readDevice (parseJson (text, name), name);
    }
    catch (const InputError& error)
    {
        throw InputError ("the device is not written, since it could not be read", error.what());
    }

    return text;
}

nlohmann::ordered_json limitsInFile (const DeviceDescription& device)
{
    return device.document.empty() ? Json() : Json::parse (device.document)["limits"];
}

std::string changedDeviceText (const DeviceDescription& device, const ModalModel& before, const ModalModel& now,
                               const std::string& change)
{
    const auto description = withChange (device.description, change);
    const auto measured = measuredChanges (device, before, now);

    if (! measured || device.document.empty())
        return deviceText (modalDeviceToJson (now, description, limitsInFile (device)));

    Json changed { { "schema", "antinode.device/1" },
                   { "name", device.name },
                   { "description", description },
                   { "limits", limitsInFile (device) } };
    measuredToJson (changed, *measured);
    changed["base"] = baseOf (Json::parse (device.document));
    return deviceText (changed);
}
} // namespace antinode
