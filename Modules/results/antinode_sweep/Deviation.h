#pragma once

#include <antinode_focus/Detuning.h>
#include <antinode_model/ModalModel.h>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace antinode
{
/** How a device that plays a design differs from the one that it was designed for. Relative: 0.01 is 1 %. */
struct Deviation
{
    double frequency = 0, damping = 0, participation = 0; ///< Of all modes alike.
    double voltage = 0;                                   ///< Of all amplifiers alike.
    DetuningSpread spread { 0, 0, 0, 0 };                 ///< Standard deviations of what each mode has of its own.
    double voltageSpread = 0;                             ///< Of each amplifier's own gain.

    bool isNone() const { return *this == Deviation {}; }
    bool operator== (const Deviation&) const;
};

/** The keys of a deviation in plans: "deviation.frequency_percent". [any] */
std::vector<std::string_view> deviationKeys();
bool isDeviationKey (std::string_view);

/** A deviation from the keys that are among these. @throws InputError  for values that are not allowed [worker] */
Deviation readDeviation (const std::vector<std::pair<std::string, nlohmann::json>>& assignments);

/** The device that deviates. What is drawn depends on the seed alone. A wrong gain counts as participation, which has
   the same effect on the motion. [worker] */
ModalModel deviated (const ModalModel&, const Deviation&, std::uint64_t seed);
} // namespace antinode
