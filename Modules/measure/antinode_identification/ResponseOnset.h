#pragma once

#include "FrequencyResponses.h"

#include <optional>

namespace antinode
{
/** The energy of impulse responses over time, summed over a few channels that count alike: what responses say before
   anything is fitted. */
struct ImpulseEnergy
{
    Eigen::VectorXd energy; ///< Over one period of 1 / (distance of lines).
    double interval = 0;    ///< s, between its samples.
    double bandwidth = 0;   ///< Hz, of the lines.
    double roughness = 0;   ///< Of a line against its two neighbours: 1 where lines are independent of each other.
};

/** By inverse transform of the responses, differentiated or integrated to a level spectrum: neither makes a response
   begin earlier.
    @return  nothing where lines are too uneven or too few
    [worker] Docs/Theory.md, section 8.2. */
std::optional<ImpulseEnergy> impulseEnergy (const FrequencyResponses&, double minimumFrequency,
                                            double maximumFrequency);

/** When the responses begin, s, to a few samples: negative only within the last twentieth of the period, which repeats.
   0 where no beginning stands out of what is before it, or where it is as early as a fit can do with.
    [worker] Docs/Theory.md, section 8.2. */
double onsetDelay (const ImpulseEnergy&);

/** Whether the energy neither begins nor decays and lines are independent of each other: noise, or the record of a
   surface that moves on its own. [worker] Docs/Theory.md, section 8.2. */
bool seemsStationary (const ImpulseEnergy&);

/** The responses as if they came later by that time, s. [worker] */
FrequencyResponses delayed (FrequencyResponses, double delay);
} // namespace antinode
