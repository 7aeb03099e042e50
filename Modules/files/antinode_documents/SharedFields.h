#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_text/JsonReader.h>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The object "lag" of a ceramic. @throws InputError [worker] */
InputLag readLag (const JsonValue&);

/** The same as JSON. [any] */
nlohmann::ordered_json lagToJson (const InputLag&);

/** Damping ratios from "damping_ratio" or "quality_factor", of which exactly one is given: one for all modes, or one
   per mode. Q = 1 / (2 xi). @throws InputError [worker] Docs/Theory.md, section 1. */
std::vector<double> readDampingRatios (const JsonObject&);

/** The damping ratio of a single mode. @throws InputError [worker] */
double readDampingRatio (const JsonObject& mode);

/** The limits of a device's ceramics. */
struct VoltageLimits
{
    double voltage = 0;   ///< U_max of every ceramic, V.
    double fullScale = 0; ///< The voltage of a sample of 1.0, V.
    double slew = 0;      ///< Of every amplifier, V/s; 0: none.
    double current = 0;   ///< Of every amplifier, A; 0: none.
    bool requiresArming =
        false; ///< A program that loads the device or a state with it stays silent until its user arms it.
};

/** The object "limits" of a device; the full scale is the limit if it is not given. @throws InputError [worker] */
VoltageLimits readLimits (const JsonValue&);

/** The key of a device that says where its modes come from. */
inline constexpr auto originKey = "origin";

/** @throws InputError [worker] Docs/FileFormats.md. */
ModeOrigin readOrigin (const JsonValue&);

/** The same as JSON. [any] */
nlohmann::ordered_json originToJson (const ModeOrigin&);

/** The device that a focus or waveforms are for, their entry `device`: a name or a file; empty: none is named.
    @throws InputError  where the entry is no text, or empty
    [worker] */
std::string readNamedDevice (const std::optional<JsonValue>& device);
} // namespace antinode
