#pragma once

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>

namespace antinode
{
/** A device to begin with. */
struct DeviceTemplate
{
    const char* name; ///< Of what is drawn: "rectangle".
    nlohmann::json (*make)();
};

/** Each with ceramics that suit it. [any] */
std::span<const DeviceTemplate> deviceTemplates();

/** The one of a name, as a device "new NAME". @throws InputError  where there is none [worker] */
nlohmann::json newDevice (const std::string& name);
} // namespace antinode
