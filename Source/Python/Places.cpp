#include "Places.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Prefixes.h>

namespace antinode
{
Eigen::MatrixX2d placesOf (const PlacePairs& millimetres, const std::string& name)
{
    Eigen::MatrixX2d places (static_cast<Eigen::Index> (millimetres.size()), 2);

    for (std::size_t i = 0; i < millimetres.size(); ++i)
        places.row (static_cast<Eigen::Index> (i)) << millimetres[i].first / milli, millimetres[i].second / milli;

    if (places.rows() == 0 || ! places.allFinite())
        throw InputError (name, "are none or not finite; allowed: at least one place on the surface, mm");

    return places;
}

Eigen::MatrixX2d inMillimetres (const Eigen::MatrixX2d& places)
{
    return milli * places;
}
} // namespace antinode
