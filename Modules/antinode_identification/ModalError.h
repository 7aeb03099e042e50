#pragma once

#include "IdentifiedModes.h"
#include "PreparedResponses.h"

namespace antinode
{
/** RMS of measured velocities less those of the modes alone, without residual terms, which a device does not have, over
   RMS of measured, dB, on the lines of the data. [worker] */
double modalError (const IdentifiedModes&, const PreparedResponses&);
} // namespace antinode
