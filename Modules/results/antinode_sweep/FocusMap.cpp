#include "FocusMap.h"

#include "PlaceMapper.h"

#include <antinode_base/InputError.h>
#include <antinode_model/SquareCells.h>
#include <antinode_numerics/EvaluatedCases.h>

#include <algorithm>

namespace antinode
{
namespace
{
constexpr std::size_t placesAtOnce = 16; // one product with the shapes for so many
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

    const auto& surface = wide.model.surface;
    const auto cells = squareCells (surface, options.places);
    map.columns = cells.columns;
    map.rows = cells.rows;
    map.xMinimum = surface.xMinimum;
    map.xMaximum = surface.xMaximum;
    map.yMinimum = surface.yMinimum;
    map.yMaximum = surface.yMaximum;
    const auto places = static_cast<std::size_t> (cells.centres.rows());
    map.places.resize (places);
    const PlaceMapper mapper (wide, focus, options);
    CaseCounter counter (
        [&] (std::uint64_t done)
        {
            if (show)
                show (static_cast<int> (done), static_cast<int> (places));
        });
    const auto mapSome = [&] (std::size_t batch)
    {
        const auto first = batch * placesAtOnce, last = std::min (first + placesAtOnce, places);
        auto some = mapper.mapped (
            cells.centres.middleRows (static_cast<Eigen::Index> (first), static_cast<Eigen::Index> (last - first)));
        std::move (some.begin(), some.end(), map.places.begin() + static_cast<std::ptrdiff_t> (first));
        counter.add (last - first);
    };
    parallelFor ((places + placesAtOnce - 1) / placesAtOnce, mapSome, options.threads);

    if (std::all_of (map.places.begin(), map.places.end(), [] (const auto& place) { return ! place.error.empty(); }))
        throw InputError ("map", "no place can be designed; the first error: " + map.places.front().error);

    return map;
}
} // namespace antinode
