#pragma once

#include "DetuningSpread.h"
#include "FocusDesign.h"

#include <antinode_model/ModalModel.h>

#include <cstdint>
#include <optional>
#include <string>

namespace antinode
{
/** The field error that is to be expected on the device itself, RMS over RMS of what the controlled modes represent. */
struct ExpectedError
{
    double median = 0;
    double high = 0;      ///< One of ten devices has more.
    std::string sentence; ///< Both, why, and what brings them down.
};

/** How far devices usually are from modes of such an origin. [any] Docs/Theory.md, section 7.4. */
DetuningSpread spreadOf (const ModeOrigin&);

/** By few draws of devices around the model, and by what its origin says of shapes: a design is as good as the modes
    that it knows. None for complex modes. [worker] Docs/Theory.md, section 7.4. */
std::optional<ExpectedError> expectedError (const ModalModel&, const FocusDesign&);

/** A device that the model may stand for, at points: detuned as its origin says, and each mode larger or smaller by
   what shapes are usually off at a point, drawn or between measured ones.
    @param number  the same gives the same device
    [worker] Docs/Theory.md, section 7.4. */
ModalModel likelyDevice (const ModalModel&, std::uint64_t number);
} // namespace antinode
