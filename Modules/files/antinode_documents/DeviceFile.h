#pragma once

#include <antinode_structure/DeviceDescription.h>

#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace antinode
{
/** A device from JSON. Docs/FileFormats.md.
    @param source  how errors name it: a file name, or "device 'staple'"
    @throws InputError  source, JSON pointer, what is wrong, what is allowed, "did you mean"
    [worker] */
DeviceDescription readDevice (const nlohmann::json&, const std::string& source);

/** A device of kind modal as JSON: what any other program can read. Written and read again it is the same to the bit:
   what Hz and mm cannot express is added in SI units, under "exact". Only shapes of more than 100 000 numbers are
   rounded to 7 digits.
    @param limits  as files have them; none: the largest ones of its ceramics
    [worker] */
nlohmann::ordered_json modalDeviceToJson (const ModalModel&, const std::string& description,
                                          const nlohmann::ordered_json& limits = {});

/** What stands in a device that hardly any has, as a number in another unit than its key says: a
   sentence for each, with the unit that is likely. [any] */
std::vector<std::string> unlikelyValues (const nlohmann::json& document);
} // namespace antinode
