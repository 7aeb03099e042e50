#pragma once

#include "Identification.h"

#include <functional>

namespace antinode
{
/** One identification of given responses with given options. */
using Identify = std::function<IdentifiedModes (const FrequencyResponses&, const IdentificationOptions&)>;

/** Identifies as the options say, and where what is left is no noise also without lines that overwhelm the modes, and
   with higher orders; gives the best, with the likely cause where that is bad. Nothing that the options say is changed.
    @throws InputError  the first one, when no attempt finds a mode
    [worker] Docs/Theory.md, section 8.2. */
IdentifiedModes bestOfAttempts (const FrequencyResponses&, const IdentificationOptions&, const Identify&);
} // namespace antinode
