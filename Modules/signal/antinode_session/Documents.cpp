#include "Documents.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/FingerFile.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_documents/Library.h>

#include <nlohmann/json.hpp>

namespace antinode
{
DeviceDocument readDeviceDocument (const nlohmann::json& json, const std::string& source)
{
    return { json.dump(), readDevice (json, source) };
}

std::shared_ptr<const DesignDocument> readDesignDocument (const nlohmann::json& json, const std::string& source)
{
    return std::make_shared<const DesignDocument> (DesignDocument {
        json.dump(), source, std::make_shared<const nlohmann::json> (json), readDesignOrigin (json, source) });
}

FocusDocument readFocusDocument (const nlohmann::json& json, const std::string& source)
{
    if (isDesignFile (json))
    {
        auto design = readDesignDocument (json, source);
        return { json["focus"].dump(), design->origin.focus, design };
    }

    return { json.dump(), readFocus (json, source) };
}

std::shared_ptr<const DeviceDocument> deviceDocument (const std::string& nameOrFile)
{
    return std::make_shared<const DeviceDocument> (readDeviceDocument (
        loadDocument (LibraryKind::device, nameOrFile), documentSource (LibraryKind::device, nameOrFile)));
}

std::shared_ptr<const FocusDocument> focusDocument (const std::string& nameOrFile)
{
    return std::make_shared<const FocusDocument> (readFocusDocument (loadDocument (LibraryKind::focus, nameOrFile),
                                                                     documentSource (LibraryKind::focus, nameOrFile)));
}

bool sayTheSame (const FocusDocument& one, const FocusDocument& other)
{
    const auto hasDesign = one.design != nullptr, otherHasDesign = other.design != nullptr;
    return one.text == other.text && hasDesign == otherHasDesign
           && (one.design == other.design || one.design->text == other.design->text);
}

FocusDocument withFingers (const FocusDocument& focus, const std::vector<Finger>& fingers)
{
    auto json = nlohmann::json::parse (focus.text);
    json.erase ("fingers");

    for (const auto& finger : fingers)
        json["fingers"].push_back (nlohmann::json (fingerToJson (finger)));

    auto changed = readFocusDocument (json, "focus");
    changed.design = focus.design;
    return changed;
}
} // namespace antinode
