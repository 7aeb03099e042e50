#include "PlacedPoints.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/NumberText.h>

#include <algorithm>
#include <set>

namespace antinode
{
namespace
{
/** The position of a name, or else of the number at its end: files of positions often contain numbers only. */
PointPlaces::const_iterator findPlace (const std::string& name, const PointPlaces& places)
{
    const auto found = places.find (name);
    return found != places.end() ? found : places.find (name.substr (name.find_last_not_of ("0123456789") + 1));
}

/** Whether two points have the same position, as in a geometry that was never filled in. */
bool coincide (const Eigen::MatrixX2d& points)
{
    std::set<std::pair<double, double>> seen;
    return std::any_of (points.rowwise().begin(), points.rowwise().end(),
                        [&] (const auto& point) { return ! seen.emplace (point[0], point[1]).second; });
}
} // namespace

void placePoints (const std::vector<MeasurementFile>& files, const MeasurementOptions& options,
                  Measurement& measurement)
{
    constexpr double apart = 1e-3, unlikely = 5; // m
    auto places = options.places;
    auto& points = measurement.responses.points;
    const auto& names = measurement.pointNames;

    for (const auto& file : files)
        places.insert (file.places.begin(), file.places.end());

    points = Eigen::MatrixX2d::Zero (static_cast<Eigen::Index> (names.size()), 2);
    measurement.hasPlaces = true;

    for (std::size_t p = 0; p < names.size(); ++p)
        if (const auto place = findPlace (names[p], places); place != places.end())
            points.row (static_cast<Eigen::Index> (p)) = place->second.transpose();
        else if (! options.places.empty())
            throw InputError ("measurement: point positions",
                              "lack the point " + inQuotes (names[p]) + " of the files");
        else
            measurement.hasPlaces = false;

    if (! measurement.hasPlaces || coincide (points))
    {
        measurement.hasPlaces = false;
        points.col (1).setZero();
        points.col (0) = apart * Eigen::VectorXd::LinSpaced (points.rows(), 0, static_cast<double> (points.rows() - 1));
        measurement.remarks.emplace_back (
            "No file gives positions of all points: they are placed 1 mm apart on a line.");
        return;
    }

    if (const Eigen::RowVector2d span = points.colwise().maxCoeff() - points.colwise().minCoeff();
        options.places.empty() && span.maxCoeff() > unlikely)
        measurement.remarks.push_back (
            formatted ("The points of the files span %g m x %g m. Are their lengths in mm? Use a set 164 of a "
                       "universal file, points_mm of a MATLAB file, or --points.",
                       span[0], span[1]));

    if (points.rows() > 1 && (points.col (0).array() == points (0, 0)).all()) // A line lies along x.
        points.col (0).swap (points.col (1));
}
} // namespace antinode
