#include "JsonText.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <charconv>
#include <vector>

namespace antinode
{
namespace
{
using Json = nlohmann::json;

std::vector<std::string_view> splitPath (std::string_view path)
{
    std::vector<std::string_view> parts;

    for (std::size_t begin = 0; begin <= path.size();)
    {
        const auto end = std::min (path.find ('.', begin), path.size());
        parts.push_back (path.substr (begin, end - begin));
        begin = end + 1;
    }

    return parts;
}

bool isIndex (std::string_view part)
{
    return ! part.empty() && part.size() < 9 && part.find_first_not_of ("0123456789") == std::string_view::npos;
}

Json& findElement (Json& list, std::string_view part, const std::string& where)
{
    if (! isIndex (part))
        throw InputError (where, inQuotes (part) + " does not fit a list; allowed: an index from 0");

    std::size_t index = 0;
    std::from_chars (part.data(), part.data() + part.size(), index);

    if (index > list.size())
        throw InputError (where, "index " + std::string (part) + " is beyond the list; allowed: 0 to "
                                     + std::to_string (list.size()));

    if (index == list.size())
        list.push_back (nullptr);

    return list[index];
}

Json& findMember (Json& node, std::string_view part, const std::string& where)
{
    if (node.is_null())
        node = isIndex (part) ? Json::array() : Json::object();

    if (node.is_array())
        return findElement (node, part, where);

    if (! node.is_object())
        throw InputError (where, inQuotes (part) + " does not fit: its parent is neither an object nor a list");

    if (isIndex (part))
        throw InputError (where, inQuotes (part) + " does not fit an object; allowed: the name of a key");

    return node[std::string (part)];
}

Json parseValue (std::string_view text)
{
    try
    {
        return parseJson (text, "value");
    }
    catch (const InputError&)
    {
        return std::string (text);
    }
}
} // namespace

void applyAssignment (nlohmann::json& root, std::string_view assignment)
{
    constexpr std::size_t maximumParts = 16;
    const auto where = "assignment " + inQuotes (assignment);
    const auto equals = assignment.find ('=');

    if (equals == std::string_view::npos)
        throw InputError (where, "has no '='; allowed: key=value, for example targets.0.x_mm=24");

    if (! isUtf8 (assignment))
        throw InputError (where, "is not UTF-8 text");

    const auto parts = splitPath (assignment.substr (0, equals));

    if (std::any_of (parts.begin(), parts.end(), [] (auto part) { return part.empty(); }))
        throw InputError (where, "has an empty key; allowed: for example targets.0.x_mm=24");

    if (parts.size() > maximumParts)
        throw InputError (where, "has too many keys; allowed: up to " + std::to_string (maximumParts));

    // A copy is changed, so that an assignment that does not fit leaves the document as it was.
    auto changed = root;
    auto* node = &changed;

    for (const auto part : parts)
        node = &findMember (*node, part, where);

    *node = parseValue (assignment.substr (equals + 1));
    root = std::move (changed);
}
} // namespace antinode
