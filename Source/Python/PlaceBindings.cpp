#include "Bindings.h"
#include "Values.h"
#include "Work.h"

#include <CommandLine/PlaceInputs.h>
#include <CommandLine/PlaceOutcome.h>

#include <nlohmann/json.hpp>

#include <pybind11/stl.h>

namespace antinode
{
namespace
{
namespace py = pybind11;

/** Places that were found. */
struct PlacedValue
{
    std::string document; ///< Of the device with its ceramics, JSON.
    PlacedCeramics placed;
};

using Placed = std::shared_ptr<PlacedValue>;

PlacedValue placeOn (const DeviceValue& device, const PlaceOptions& options,
                     const std::vector<FocusDescription>& focuses, const ShowProgress& progress)
{
    const auto document = nlohmann::json::parse (device.document);
    const auto isPlate = deviceExtent (device.description).kind == SurfaceKind::plate;
    const auto like = ceramicLike (document, isPlate, options.size);
    const auto ceramic = describedCeramic (document, like);
    auto placing = placingOptions (options, ceramic);

    if (! focuses.empty())
        placing.cost = peakVoltageCost (device.description, focuses);

    auto placed = placeCeramics (device.description, ceramic, placing,
                                 [&] (double share)
                                 {
                                     if (progress)
                                         progress ("Placing ceramics", share);
                                 });
    return { placedDevice (document, like, placed.ceramics).dump(), std::move (placed) };
}

Placed place (const DeviceValue& device, const PlaceOptions& options,
              const std::vector<std::shared_ptr<FocusValue>>& focuses, py::object progress)
{
    std::vector<FocusDescription> wanted;
    wanted.reserve (focuses.size());

    for (const auto& focus : focuses)
        wanted.push_back (focus->description);

    Work work (std::move (progress));
    const auto show = work.progress();
    return work.run ([&] { return std::make_shared<PlacedValue> (placeOn (device, options, wanted, show)); });
}
} // namespace

void bindPlace (py::module_& module)
{
    py::class_<PlaceOptions> options (module, "PlaceOptions");
    options.def (py::init());
    options.def_readwrite ("count", &PlaceOptions::count);
    options.def_readwrite ("modes", &PlaceOptions::modes);
    options.def_readwrite ("size_mm", &PlaceOptions::size);
    options.def_readwrite ("step_mm", &PlaceOptions::step);
    options.def_readwrite ("rim_mm", &PlaceOptions::edgeDistance);
    options.def_readwrite ("focus_time_ms", &PlaceOptions::duration);
    options.def_readwrite ("free_edge_mm", &PlaceOptions::freeEdge);
    options.def_readwrite ("keep_out_mm", &PlaceOptions::keepOut);
    options.def_readwrite ("frozen", &PlaceOptions::isFrozen);

    py::class_<PlacedValue, Placed> bound (module, "Placed");
    bound.def_static ("make", &place);
    bound.def_property_readonly ("document", [] (const PlacedValue& value) { return value.document; });
    bound.def_property_readonly ("controllability",
                                 [] (const PlacedValue& value) { return value.placed.controllability; });
    bound.def_property_readonly ("controllability_with_ceramics",
                                 [] (const PlacedValue& value) { return value.placed.resolved; });
    bound.def_property_readonly ("candidates", [] (const PlacedValue& value) { return value.placed.candidates; });
}
} // namespace antinode
