#include "DeviceButton.h"

#include "JuceText.h"

#include <nlohmann/json.hpp>

namespace antinode
{
DeviceButton::DeviceButton (const std::function<void (std::shared_ptr<const DeviceDocument>)>& load)
    : LibraryButton (LibraryKind::device, "device",
                     [load] (const nlohmann::json& json, const std::string& source)
                     { load (std::make_shared<const DeviceDocument> (readDeviceDocument (json, source))); })
{
}

void DeviceButton::setDevice (const DeviceDocument& device)
{
    setButtonText ("Device: " + fromUtf8 (device.description.name));
}
} // namespace antinode
