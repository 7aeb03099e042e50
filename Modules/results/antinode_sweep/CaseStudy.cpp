#include "CaseStudy.h"

#include <antinode_text/JsonText.h>

namespace antinode
{
CaseKeys keysOf (const CaseKeys& all, std::string_view prefix)
{
    CaseKeys some;

    for (const auto& [key, value] : all)
        if (key.starts_with (prefix))
            some.emplace_back (key.substr (prefix.size()), value);

    return some;
}

std::string textOf (const CaseKeys& keys)
{
    std::string text;

    for (const auto& [key, value] : keys)
        text += key + "=" + value.dump() + "\n";

    return text;
}

nlohmann::json assigned (nlohmann::json document, const CaseKeys& keys)
{
    for (const auto& [key, value] : keys)
        applyAssignment (document, key + "=" + value.dump());

    return document;
}
} // namespace antinode
