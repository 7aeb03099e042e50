#pragma once

#include "DetuningSpread.h"
#include "FocusDesign.h"

#include <antinode_model/ModalModel.h>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The property of a device that deviates. */
enum class ToleranceKind
{
    frequency,
    damping,
    participation,
    drift
};

/** One deviating property, all others being nominal. */
struct ToleranceCause
{
    std::optional<int> mode; ///< None: all of them, of a drift.
    ToleranceKind kind = ToleranceKind::frequency;
    double fieldError = 0; ///< RMS over the errors of the RMS change of the field / RMS of the wanted field.
};

/** The effect of the spread of each mode's frequency, damping and participations alone on the field at the focus, and
   of a drift of all frequencies; controlled modes and others, the worst first. Those without a spread are left out.
   Reference is the truncated field. [worker] Docs/Theory.md, section 7.4. */
std::vector<ToleranceCause> toleranceCauses (const ModalModel&, const FocusDesign&, const DetuningSpread&);

/** "Mode 7 (6120 Hz): its frequency alone changes the field by 0.8 %." [any] */
std::string causeSentence (const ToleranceCause&, const ModalModel&);
} // namespace antinode
