#pragma once

#include "RepeatedPower.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace antinode
{
/** The power of a focus, or why it cannot be told. */
struct FocusPower
{
    std::string obstacle; ///< Empty where the rest holds.
    PowerFlow once;
    RepeatedPower repeated;
};

/** @param voltages     N_b x N_s, V, from rest
    @param repetitions  per second
    @throws InputError  where the repetitions are not usable; Cancelled as checkWatch()
    [worker] Docs/Theory.md, section 6.8. */
FocusPower focusPower (const ModalModel&, const Eigen::MatrixXd& voltages, Playback, double repetitions);

/** The key "power" of summary.json and design.json. [any] */
nlohmann::ordered_json powerToJson (const ModalModel&, const FocusPower&);

/** Three short sentences: current, power, amplifier; or why there are none. [any] */
std::vector<std::string> powerInWords (const ModalModel&, const FocusPower&);
} // namespace antinode
