#pragma once

#include <antinode_identification/IdentifiedModes.h>
#include <antinode_model/ModalModel.h>
#include <antinode_structure/DeviceDescription.h>
#include <antinode_text/JsonReader.h>

#include <nlohmann/json.hpp>

#include <string>

namespace antinode
{
/** A device with a "base": what was measured of a drawn one.
    @param drawing  what its key "base" says
    @throws InputError  when sizes do not agree or a number is not allowed [worker] */
MeasuredDevice readMeasuredDevice (const JsonValue& device, std::shared_ptr<const DeviceDescription> drawing);

/** The same as JSON: "origin", "ceramics" and "modes". [worker] */
void measuredToJson (nlohmann::ordered_json& device, const MeasuredDevice&);

/** The text of a device file, once it is known that it can be read.
    @throws InputError  where readDevice or a reader of files would refuse it [worker] */
std::string deviceText (const nlohmann::ordered_json& device);

/** The file of a device after a command has changed it: what its file said of limits, arming and all else stays. A
   drawn device stays one, with its drawing as the base; where shapes have changed, too, it is of kind
   modal.
    @param device  as it was read
    @param before  its model, as solveStructure gives it
    @param now     the model after the change
    @param change  what was done, a sentence behind its description
    @throws InputError  as deviceText [worker] Docs/FileFormats.md. */
std::string changedDeviceText (const DeviceDescription& device, const ModalModel& before, const ModalModel& now,
                               const std::string& change);

/** The limits as a device's file has them; none where it was made without a file. [any] */
nlohmann::ordered_json limitsInFile (const DeviceDescription&);

/** An identified device as JSON of kind modal: as modalDeviceToJson(), with the standard deviations of frequency,
   damping ratio and participation of every mode where they are known, and the delay of the measurement.
    @param model   made of these modes, in their order
    @param limits  as modalDeviceToJson
    [worker] Docs/FileFormats.md. */
nlohmann::ordered_json identifiedDeviceToJson (const ModalModel& model, const IdentifiedModes&,
                                               const std::string& description,
                                               const nlohmann::ordered_json& limits = {});
} // namespace antinode
