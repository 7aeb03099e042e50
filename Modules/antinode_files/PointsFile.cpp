#include "PointsFile.h"

#include "CsvResponses.h"
#include "MessageText.h"
#include "NaturalOrder.h"
#include "PhysicalRanges.h"

#include <antinode_model/InputError.h>

#include <fstream>

namespace antinode
{
Eigen::MatrixX2d readPointsFile (const std::filesystem::path& path)
{
    constexpr std::uintmax_t most = 16 << 20;
    const auto source = printable (path.string(), 300);
    std::error_code error;

    if (! std::filesystem::is_regular_file (path, error))
        throw InputError (source, "cannot be read: it is missing or no plain file");

    if (std::filesystem::file_size (path, error) > most)
        throw InputError (source, "is larger than 16 MiB");

    std::ifstream file (path, std::ios::binary);
    const auto places = placesFromCsv (std::string { std::istreambuf_iterator<char> (file), {} }, source);
    std::vector<std::string> names;

    for (const auto& [name, place] : places)
        names.push_back (name);

    if (names.empty() || names.size() > ranges::maximumPoints)
        throw InputError (source, "has " + std::to_string (names.size()) + " points, allowed are 1 to "
                                      + std::to_string (ranges::maximumPoints));

    names = inNaturalOrder (std::move (names));
    Eigen::MatrixX2d points (static_cast<Eigen::Index> (names.size()), 2);

    for (Eigen::Index p = 0; p < points.rows(); ++p)
        points.row (p) = places.at (names[static_cast<std::size_t> (p)]);

    return points;
}
} // namespace antinode
