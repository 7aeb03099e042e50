#include "PointsFile.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/WholeFile.h>
#include <antinode_text/CsvText.h>
#include <antinode_text/JsonReader.h>

#include <optional>
#include <vector>

namespace antinode
{
namespace
{
/** x and y of a line, or x alone; nothing if it holds anything else. */
std::optional<Eigen::RowVector2d> placeIn (std::string_view line)
{
    const auto separator = csvSeparator (line);
    const auto cells = csvCells (line, separator);

    if (cells.empty() || cells.size() > 2)
        return std::nullopt;

    const auto x = csvNumber (cells.front(), separator);
    const auto y = csvNumber (cells.size() > 1 ? cells.back() : "0", separator);

    if (! x || ! y || ! ranges::positionMillimetre.contains (*x) || ! ranges::positionMillimetre.contains (*y))
        return std::nullopt;

    return Eigen::RowVector2d (*x, *y) / 1000;
}
} // namespace

Eigen::MatrixX2d decodePoints (std::string_view bytes, const std::string& source)
{
    const auto text = csvText (bytes);
    std::vector<Eigen::RowVector2d> places;
    bool mayBeHeading = true;

    for (const auto& [line, number] : csvLines (text))
    {
        if (csvCommentMark (line) > 0)
            continue;

        if (const auto place = placeIn (line))
            places.push_back (*place);
        else if (! mayBeHeading)
            throw InputError (source + ": line " + std::to_string (number),
                              "is " + inQuotes (trimmedText (line)) + "; allowed: x and y in mm, for example 12.5,30");

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
