#include "JsonText.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/WholeFile.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

namespace antinode
{
namespace
{
using Json = nlohmann::json;

constexpr std::size_t maximumDepth = 64;
constexpr std::size_t longestName = 300; ///< Of a source in a message, in bytes.

std::string lineAndColumn (std::string_view text, std::size_t position)
{
    const auto before = text.substr (0, position > 0 ? position - 1 : 0);
    const auto line = 1 + std::count (before.begin(), before.end(), '\n');
    const auto lastBreak = before.rfind ('\n');
    const auto column = before.size() - (lastBreak == std::string_view::npos ? 0 : lastBreak + 1) + 1;
    return "line " + std::to_string (line) + ", column " + std::to_string (column);
}

/** The parser's message without its own name and position and without the raw text. */
std::string errorReason (const nlohmann::detail::exception& error)
{
    constexpr int numberOverflow = 406;
    std::string reason = error.what();

    if (error.id == numberOverflow)
        return "has a number that is too large: " + printable (reason.substr (reason.find ('\'')))
               + "; allowed: up to 1.7e308";

    if (const auto place = reason.find ("column "); place != std::string::npos)
        reason.erase (0, reason.find (": ", place) + 2);

    if (const auto token = reason.find ("; last read: "); token != std::string::npos)
        reason.erase (token, reason.find ("; expected", token) - token);

    return "is not valid JSON: " + printable (reason, 160);
}

/** Builds the document from the parser's events and refuses what nlohmann's own builder lets pass: a key that is given
   twice (it keeps the last) and nesting without end. */
class StrictBuilder final : public nlohmann::json_sax<Json>
{
public:
    StrictBuilder (std::string_view textToRead, const std::string& sourceOfText)
        : text (textToRead), source (sourceOfText)
    {
    }

    Json takeDocument() { return std::move (document); }

    bool null() override { return add (nullptr); }
    bool boolean (bool value) override { return add (value); }
    bool number_integer (number_integer_t value) override { return add (value); }
    bool number_unsigned (number_unsigned_t value) override { return add (value); }
    bool number_float (number_float_t value, const string_t&) override { return add (value); }
    bool string (string_t& value) override { return add (std::move (value)); }
    bool binary (binary_t&) override { return false; }
    bool start_object (std::size_t) override { return open (Json::object()); }
    bool start_array (std::size_t) override { return open (Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key (string_t& name) override
    {
        keys.back() = name;

        if (containers.back()->contains (name))
            throw InputError (source + ": " + printable (pointer(), longestName), "is given twice; allowed: once");

        return true;
    }

    bool parse_error (std::size_t position, const std::string&, const nlohmann::detail::exception& error) override
    {
        throw InputError (source + ": " + lineAndColumn (text, position), errorReason (error));
    }

private:
    Json* add (Json&& value, Json*& place)
    {
        if (containers.empty())
            place = &(document = std::move (value));
        else if (containers.back()->is_array())
            place = &containers.back()->emplace_back (std::move (value));
        else
            place = &((*containers.back())[keys.back()] = std::move (value));

        return place;
    }

    bool add (Json&& value)
    {
        Json* place = nullptr;
        return add (std::move (value), place) != nullptr;
    }

    bool open (Json&& container)
    {
        if (containers.size() == maximumDepth)
            throw InputError (source,
                              "is nested too deeply; allowed: up to " + std::to_string (maximumDepth) + " levels");

        Json* place = nullptr;
        containers.push_back (add (std::move (container), place));
        keys.emplace_back();
        return true;
    }

    bool close()
    {
        containers.pop_back();
        keys.pop_back();
        return true;
    }

    std::string pointer() const
    {
        Json::json_pointer result;

        for (std::size_t i = 0; i < containers.size(); ++i)
            result.push_back (containers[i]->is_array() ? std::to_string (containers[i]->size() - 1) : keys[i]);

        return result.to_string();
    }

    std::string_view text;
    const std::string& source;
    Json document;
    std::vector<Json*> containers; ///< The open ones, outermost first.
    std::vector<std::string> keys; ///< The key last seen in each of them.
};
bool hasObjects (const nlohmann::ordered_json& value)
{
    return value.is_object()
           || (value.is_array()
               && std::any_of (value.begin(), value.end(), [] (const auto& item) { return hasObjects (item); }));
}

void appendReadable (std::string& text, const nlohmann::ordered_json& value, const std::string& indent)
{
    if (value.empty() || ! hasObjects (value))
    {
        text += value.dump();
        return;
    }

    const auto deeper = indent + "  ";
    text += value.is_object() ? '{' : '[';

    for (auto item = value.begin(); item != value.end(); ++item)
    {
        text += (item == value.begin() ? "\n" : ",\n") + deeper;

        if (value.is_object())
            text += nlohmann::json (item.key()).dump() + ": ";

        appendReadable (text, *item, deeper);
    }

    text += "\n" + indent + (value.is_object() ? '}' : ']');
}
} // namespace

std::string readableJson (const nlohmann::ordered_json& value)
{
    std::string text;
    appendReadable (text, value, {});
    return text + "\n";
}

nlohmann::json parseJson (std::string_view text, const std::string& source)
{
    const auto name = printable (source, longestName);

    if (text.find_first_not_of (" \t\r\n") == std::string_view::npos)
        throw InputError (name, "is empty; allowed: a JSON document");

    // The parser takes a NUL byte for the end of the text and would not look at what follows.
    if (const auto nul = text.find ('\0'); nul != std::string_view::npos)
        throw InputError (name + ": " + lineAndColumn (text, nul + 1), "has a NUL byte; allowed: UTF-8 text");

    StrictBuilder builder (text, name);
    nlohmann::json::sax_parse (text, &builder);
    return builder.takeDocument();
}

nlohmann::json readJsonFile (const std::filesystem::path& path)
{
    return parseJson (readWholeFile (path, { "a JSON file" }), path.string());
}

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
/** What is set replaces the size in another unit. */
void eraseOtherSizes (Json& parent, std::string_view set)
{
    constexpr std::array<std::array<std::string_view, 3>, 2> sizes { { { "peak_velocity_mm_s", "peak_level_dB_SL" },
                                                                       { "level_um", "level_mm_s", "level_dB_SL" } } };

    for (const auto& names : sizes)
        if (parent.is_object() && std::find (names.begin(), names.end(), set) != names.end())
            for (const auto name : names)
                if (name != set)
                    parent.erase (std::string (name));
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

    auto* parent = node;

    for (const auto part : parts)
    {
        parent = node;
        node = &findMember (*parent, part, where);
    }

    *node = parseValue (assignment.substr (equals + 1));
    eraseOtherSizes (*parent, parts.back());
    root = std::move (changed);
}
} // namespace antinode
