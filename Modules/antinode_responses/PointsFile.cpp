#include "PointsFile.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/WholeFile.h>
#include <antinode_text/PhysicalRanges.h>

#include <charconv>
#include <optional>
#include <vector>

namespace antinode
{
namespace
{
std::string_view trimmed (std::string_view text)
{
    constexpr std::string_view blanks = " \t\r";
    const auto first = text.find_first_not_of (blanks);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr (first, text.find_last_not_of (blanks) - first + 1);
}

std::optional<double> numberIn (std::string_view text)
{
    double value = 0;
    text = trimmed (text);
    const auto [end, error] = std::from_chars (text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && ! text.empty() ? std::optional (value)
                                                                                      : std::nullopt;
}

/** x and y of a line, or x alone; nothing if it holds anything else. */
std::optional<Eigen::RowVector2d> placeIn (std::string_view line)
{
    const auto separator = line.find_first_of (",;\t");
    const auto x = numberIn (line.substr (0, separator));
    const auto y = separator == std::string_view::npos ? std::optional (0.0) : numberIn (line.substr (separator + 1));

    if (! x || ! y || ! ranges::positionMillimetre.contains (*x) || ! ranges::positionMillimetre.contains (*y))
        return std::nullopt;

    return Eigen::RowVector2d (*x, *y) / 1000;
}
} // namespace

Eigen::MatrixX2d decodePoints (std::string_view text, const std::string& source)
{
    std::vector<Eigen::RowVector2d> places;
    std::size_t number = 0;
    bool mayBeHeading = true;

    for (auto rest = text; ! rest.empty(); ++number)
    {
        const auto end = std::min (rest.find ('\n'), rest.size());
        const auto line = trimmed (rest.substr (0, end));
        rest.remove_prefix (std::min (end + 1, rest.size()));

        if (line.empty() || line.front() == '#')
            continue;

        if (const auto place = placeIn (line))
            places.push_back (*place);
        else if (! mayBeHeading)
            throw InputError (source + ": line " + std::to_string (number + 1),
                              "is " + inQuotes (line) + "; allowed: x and y in mm, for example 12.5,30");

        mayBeHeading = false;

        if (places.size() > ranges::maximumPoints)
            throw InputError (source, "has more than " + std::to_string (ranges::maximumPoints) + " points");
    }

    if (places.empty())
        throw InputError (source, "has no point; allowed: lines of x and y in mm");

    Eigen::MatrixX2d points (static_cast<Eigen::Index> (places.size()), 2);

    for (Eigen::Index p = 0; p < points.rows(); ++p)
        points.row (p) = places[static_cast<std::size_t> (p)];

    return points;
}

Eigen::MatrixX2d readPointsFile (const std::filesystem::path& path)
{
    return decodePoints (readWholeFile (path, { "a list of points", 16 << 20 }), printable (path.string(), 300));
}
} // namespace antinode
