#pragma once

#include "DetuningSpread.h"
#include "FocusDesign.h"

#include <antinode_model/ModalModel.h>

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
} // namespace antinode
