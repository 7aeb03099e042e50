#include "Documents.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/FingerFile.h>
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

FocusDocument withFingers (const FocusDocument& focus, const std::vector<Finger>& fingers)
{
    auto json = nlohmann::json::parse (focus.text);
    json.erase ("fingers");

    for (const auto& finger : fingers)
        json["fingers"].push_back (nlohmann::json (fingerToJson (finger)));

    return readFocusDocument (json, "focus");
}
} // namespace antinode
