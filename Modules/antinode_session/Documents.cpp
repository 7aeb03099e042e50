#include "Documents.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/FocusFile.h>

#include <nlohmann/json.hpp>

namespace antinode
{
DeviceDocument readDeviceDocument (const nlohmann::json& json, const std::string& source)
{
    return { json.dump(), readDevice (json, source) };
}

FocusDocument readFocusDocument (const nlohmann::json& json, const std::string& source)
{
    return { json.dump(), readFocus (json, source) };
}
} // namespace antinode
