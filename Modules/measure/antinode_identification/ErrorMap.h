#pragma once

#include "Identification.h"
#include "IdentifiedModes.h"

#include <string>

namespace antinode
{
/** Two dB figures of the error between two frequencies added: that of the energy as it is, and that of spans of lines
   which count alike, however weak they are. The lower the better.
    @throws Cancelled  as checkWatch()
    [worker] */
double errorBetween (const FrequencyResponses&, const IdentifiedModes&, const FrequencyBand&);

/** Where most of the error lies, and what may help, as a sentence.
    @throws Cancelled  as checkWatch()
    [worker] */
std::string sayWhere (const FrequencyResponses&, const IdentifiedModes&);
} // namespace antinode
