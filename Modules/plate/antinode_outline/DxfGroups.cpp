#include "DxfGroups.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace antinode
{
namespace
{
std::string_view trimmed (std::string_view text)
{
    const auto first = text.find_first_not_of (" \t\r");
    return first == std::string_view::npos ? std::string_view {}
                                           : text.substr (first, text.find_last_not_of (" \t\r") + 1 - first);
}

/** The next line; nothing at the end. */
std::optional<std::string_view> nextLine (std::string_view& rest)
{
    if (rest.empty())
        return std::nullopt;

    const auto end = rest.find ('\n');
    const auto line = rest.substr (0, end);
    rest.remove_prefix (end == std::string_view::npos ? rest.size() : end + 1);
    return trimmed (line);
}
} // namespace

std::string_view DxfRecord::text (int code) const
{
    const auto found =
        std::find_if (groups.begin(), groups.end(), [code] (const auto& group) { return group.code == code; });
    return found == groups.end() ? std::string_view {} : found->value;
}

double DxfRecord::number (int code, double otherwise, const std::string& source) const
{
    const auto found =
        std::find_if (groups.begin(), groups.end(), [code] (const auto& group) { return group.code == code; });
    return found == groups.end() ? otherwise : dxfNumber (*found, source);
}

int DxfRecord::integer (int code, int otherwise, const std::string& source) const
{
    return static_cast<int> (std::clamp (number (code, otherwise, source), -1e9, 1e9));
}

std::vector<double> DxfRecord::numbers (int code, const std::string& source) const
{
    std::vector<double> values;

    for (const auto& group : groups)
        if (group.code == code)
            values.push_back (dxfNumber (group, source));

    return values;
}

double dxfNumber (const DxfGroup& group, const std::string& source)
{
    double value = 0;
    auto text = group.value;

    if (! text.empty() && text.front() == '+')
        text.remove_prefix (1);

    const auto [end, error] = std::from_chars (text.data(), text.data() + text.size(), value);

    if (error != std::errc() || end != text.data() + text.size() || ! std::isfinite (value))
        throw InputError (source + ": line " + std::to_string (group.line), inQuotes (group.value) + " stands in group "
                                                                                + std::to_string (group.code)
                                                                                + "; allowed: a number");

    return value;
}

std::vector<DxfRecord> readDxf (std::string_view bytes, const std::string& source)
{
    if (bytes.substr (0, 18) == "AutoCAD Binary DXF")
        throw InputError (source, "is a binary DXF file; allowed: DXF as text");

    std::vector<DxfRecord> records;

    for (long line = 1;; line += 2)
    {
        const auto code = nextLine (bytes);
        const auto value = nextLine (bytes);

        if (! code || (code->empty() && ! value))
            return records;

        DxfGroup group { 0, value.value_or (""), line + 1 };
        const auto [end, error] = std::from_chars (code->data(), code->data() + code->size(), group.code);

        if (error != std::errc() || end != code->data() + code->size() || ! value)
            throw InputError (source + ": line " + std::to_string (line),
                              inQuotes (*code)
                                  + " stands there; allowed: an SVG file, or DXF's codes and values, "
                                    "each in a line of its own");

        if (group.code == 0)
            records.push_back ({ group.value, {}, group.line });
        else if (! records.empty())
            records.back().groups.push_back (group);
    }
}
} // namespace antinode
