#pragma once

#include <antinode_structure/DeviceDescription.h>
#include <antinode_text/JsonReader.h>

namespace antinode
{
/** A device with a "base": what was measured of a drawn one.
    @param drawing  what its key "base" says
    @throws InputError  when sizes do not agree or a number is not allowed [worker] */
MeasuredDevice readMeasuredDevice (const JsonValue& device, std::shared_ptr<const DeviceDescription> drawing);

/** The same as JSON: "origin", "ceramics" and "modes". [worker] */
void measuredToJson (nlohmann::ordered_json& device, const MeasuredDevice&);
} // namespace antinode
