#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_structure/DeviceDescription.h>

#include <nlohmann/json.hpp>

#include <string>

namespace antinode
{
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
} // namespace antinode
