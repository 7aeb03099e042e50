#pragma once

#include "FocusDescription.h"

#include <antinode_model/ModalModel.h>
#include <antinode_model/VoltageProgram.h>

#include <optional>
#include <string>

namespace antinode
{
/** What limits a ceramic. */
enum class LimitKind
{
    ceramic,   ///< The voltage limit that the device has for it.
    focus,     ///< The voltage limit of the focus.
    amplifier, ///< The volts of a full-scale sample at its own output.
    fullScale, ///< The volts of a full-scale sample of the device.
    slew,      ///< The slew rate of its amplifier.
    current    ///< The current of its amplifier, into its capacitance.
};

/** How much of a limit is used, and where: by the ceramic and at the time that use most of it. */
struct LimitUse
{
    LimitKind kind = LimitKind::ceramic;
    int ceramic = 0;
    double time = 0;    ///< s after the focus, the first one of a train; before it where negative.
    double used = 0;    ///< V, of a slew rate V/s, of a current A.
    double allowed = 0; ///< The same.

    double share() const { return used / allowed; }
};

/** The uses of all limits. */
struct LimitUses
{
    LimitUse voltage;
    std::optional<LimitUse> slew; ///< Slew rate or current; none where neither is limited.

    /** The use of the larger share. */
    const LimitUse& nearest() const { return slew && slew->share() > voltage.share() ? *slew : voltage; }
};

/** What limits the voltage of a ceramic: the least of its limits, and of equal ones the first of ceramic, focus,
   amplifier, full scale. [any] */
LimitKind voltageLimitKind (const ModalModel&, const AllocationChoice&, std::size_t ceramic);

/** What counts as no voltage limit, V. */
inline constexpr double noVoltageLimit = 1e5;

/** A model whose ceramics and outputs limit no voltage, for comparing what focuses need. Slew rates stay limited. [any]
 */
ModalModel withoutVoltageLimits (ModalModel);

/** How much of their limits the voltages of a program use, to 1e-4, from its first oscillation to its last; of a free
   waveform at its samples, its slew rate at 8 places per sample. All 0 for a program without either.
    @throws Cancelled  when a watch of this thread says no
    [worker] Docs/Theory.md, section 4.6. */
LimitUses limitUses (const ModalModel&, const AllocationChoice&, const VoltageProgram&);

/** Whether the voltages touch a limit: it shapes them, or cuts them. [any] */
bool isReached (const LimitUse&);

/** A limit by its name: "full scale". [any] */
std::string limitName (LimitKind);

/** Where a limit is set, as errors name it: "device: full scale". [any] */
std::string limitField (LimitKind);

/** An amount in the unit of a limit: "1.5 V", "0.2 V/us", "2 mA". [any] */
std::string limitAmount (LimitKind, double amount);

/** The ceramic and the time of a use: "ceramic 3 (C3)", "0.31 ms before the focus". [any] */
std::string limitedCeramic (const ModalModel&, const LimitUse&);
std::string limitTime (const LimitUse&);

/** One sentence: which limit binds, or is the nearest; where, when, and how much of it is used. [any] */
std::string limitSentence (const ModalModel&, const LimitUse&);
} // namespace antinode
