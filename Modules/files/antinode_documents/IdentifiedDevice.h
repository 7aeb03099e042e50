#pragma once

#include <antinode_identification/IdentifiedModes.h>
#include <antinode_model/ModalModel.h>

#include <nlohmann/json.hpp>

namespace antinode
{
/** An identified device as JSON of kind modal: as modalDeviceToJson(), with the standard deviations of frequency,
   damping ratio and participation of every mode where they are known, and the delay of the measurement.
    @param model   made of these modes, in their order
    @param limits  as modalDeviceToJson
    [worker] Docs/FileFormats.md. */
nlohmann::ordered_json identifiedDeviceToJson (const ModalModel& model, const IdentifiedModes&,
                                               const std::string& description,
                                               const nlohmann::ordered_json& limits = {});
} // namespace antinode
