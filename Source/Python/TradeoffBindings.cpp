#include "Bindings.h"
#include "Pictures.h"
#include "Values.h"
#include "Work.h"

#include <CommandLine/DesignTradeoffs.h>

#include <nlohmann/json.hpp>

#include <pybind11/stl.h>

namespace antinode
{
namespace
{
namespace py = pybind11;

using Compared = std::shared_ptr<DesignTradeoff>;

Compared tradeoffOf (const FocusValue& focus, const DeviceValue& device, const DesignSettings& settings,
                     py::object progress)
{
    Work work (std::move (progress));
    const auto show = work.progress();
    return work.run (
        [&]
        {
            const auto tell = [&] (const DesignTradeoff&, double share)
            {
                if (show)
                    show ("Designing", share);
            };
            return std::make_shared<DesignTradeoff> (designTradeoff (device.description, focusWith (focus, settings),
                                                                     playbackOf (settings), settings.usesCache, tell));
        });
}
} // namespace

void bindTradeoff (py::module_& module)
{
    py::class_<DesignTradeoff, Compared> bound (module, "Tradeoff");
    bound.def_static ("make", &tradeoffOf);
    bound.def_property_readonly ("numbers",
                                 [] (const DesignTradeoff& value) { return tradeoffDocument (value).dump(); });
    bound.def ("text", [] (const DesignTradeoff& value) { return tradeoffInWords (value); });
    bound.def ("save", [] (const DesignTradeoff& value, const std::string& folder)
               { workAway ([&] { writeTradeoff (folder, value); }); });
    bindFigures (bound, [] (const DesignTradeoff& value) { return tradeoffPage (value); });
}
} // namespace antinode
