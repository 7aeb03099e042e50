#include "FocusMap.h"

#include "PlaceMapper.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <cmath>
#include <mutex>

namespace antinode
{
namespace
{
constexpr std::size_t placesAtOnce = 16; // one product with the shapes for so many

/** Centres of cells that are about square. */
void layOut (FocusMap& map, const Surface& surface, int places)
{
    const auto width = surface.xMaximum - surface.xMinimum, height = surface.yMaximum - surface.yMinimum;
    const auto isLine = surface.kind == SurfaceKind::line;
    map.columns = isLine ? places : std::max (1L, std::lround (std::sqrt (places * width / height)));
    map.rows = isLine ? 1 : std::max (1L, std::lround (places / static_cast<double> (map.columns)));
    map.xMinimum = surface.xMinimum;
    map.xMaximum = surface.xMaximum;
    map.yMinimum = surface.yMinimum;
    map.yMaximum = surface.yMaximum;
}

std::vector<std::pair<double, double>> placesOf (const FocusMap& map)
{
    std::vector<std::pair<double, double>> places;

    for (Eigen::Index j = 0; j < map.rows; ++j)
        for (Eigen::Index i = 0; i < map.columns; ++i)
        {
            const auto x = (static_cast<double> (i) + 0.5) / static_cast<double> (map.columns);
            const auto y = (static_cast<double> (j) + 0.5) / static_cast<double> (map.rows);
            places.emplace_back (std::lerp (map.xMinimum, map.xMaximum, x), std::lerp (map.yMinimum, map.yMaximum, y));
        }

    return places;
}
} // namespace

FocusMap mapFocus (const WideModel& wide, const FocusDescription& focus, const MapOptions& options,
                   const std::function<void (int done, int all)>& show)
{
    if (! focus.fingers.empty())
        throw InputError ("focus: fingers", "rest on the surface; allowed in a map: none");

    FocusMap map;
    map.device = wide.model.name;
    map.focus = focus.name;
    map.voltageLimit = voltageLimits (wide.model).maxCoeff();

    if (focus.allocation.voltageLimit)
        map.voltageLimit = std::min (map.voltageLimit, *focus.allocation.voltageLimit);

    layOut (map, wide.model.surface, options.places);
    const auto places = placesOf (map);
    map.places.resize (places.size());
    const PlaceMapper mapper (wide, focus, options);
    std::mutex mutex;
    int done = 0;
    const auto mapSome = [&] (std::size_t batch)
    {
        const auto first = batch * placesAtOnce, last = std::min (first + placesAtOnce, places.size());
        auto some = mapper.mapped ({ places.begin() + static_cast<std::ptrdiff_t> (first),
                                     places.begin() + static_cast<std::ptrdiff_t> (last) });
        std::move (some.begin(), some.end(), map.places.begin() + static_cast<std::ptrdiff_t> (first));
        const std::lock_guard lock (mutex);
        done += static_cast<int> (last - first);

        if (show)
            show (done, static_cast<int> (places.size()));
    };
    parallelFor ((places.size() + placesAtOnce - 1) / placesAtOnce, mapSome, options.threads);

    if (std::all_of (map.places.begin(), map.places.end(), [] (const auto& place) { return ! place.error.empty(); }))
        throw InputError ("map", "no place can be designed for; the first says: " + map.places.front().error);

    return map;
}
} // namespace antinode
