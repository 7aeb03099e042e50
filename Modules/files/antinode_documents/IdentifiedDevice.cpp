#include "IdentifiedDevice.h"

#include "DeviceFile.h"
#include "FileUnits.h"

#include <antinode_text/EigenJson.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace antinode
{
nlohmann::ordered_json identifiedDeviceToJson (const ModalModel& model, const IdentifiedModes& modes,
                                               const std::string& description, const nlohmann::ordered_json& limits)
{
    auto device = modalDeviceToJson (model, description, limits);
    const auto& deviations = modes.deviations;
    const auto areKnown = [&] (const auto& values) { return values.rows() == model.modes() && values.allFinite(); };
    device["delay_s"] = modes.delay;

    if (deviations.delay > 0 && std::isfinite (deviations.delay))
        device["delay_standard_deviation_s"] = deviations.delay;

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        auto& mode = device["modes"][static_cast<std::size_t> (k)];

        if (areKnown (deviations.angularFrequencies))
            mode["frequency_standard_deviation_Hz"] = toHertz (deviations.angularFrequencies[k]);

        if (areKnown (deviations.dampingRatios))
            mode["damping_ratio_standard_deviation"] = deviations.dampingRatios[k];

        if (areKnown (deviations.participation))
            mode["participation_standard_deviation_per_V"] = toJsonList (deviations.participation.row (k));
    }

    return device;
}
} // namespace antinode
