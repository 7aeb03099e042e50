#pragma once

#include "FrequencyResponses.h"
#include "IdentifiedModes.h"

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

/** The recording of the impulse responses whose Fourier transforms are the responses. */
struct RecordEffects
{
    double length = 0;      ///< s: T, where the record is cut off; 0: it is not.
    double windowDecay = 0; ///< 1/s: of an exponential window e^{-at} that was laid over it; 0: there was none.
};

/** Responses under an exponential window in the form that modes of another damping have: a window e^{-at} puts i omega
   + a for i omega, also in the numerator, which is corrected here. [worker] Docs/Theory.md, section 8.1. */
FrequencyResponses withModalNumerators (FrequencyResponses, const RecordEffects&);

/** Modes without what record and window did to them: a record cut off at T multiplies the residues of a pole s by 1 -
   e^{sT} on the lines k / T, so participations are divided by its real part (a mode is real); a window adds its decay
   rate to all others, so it is subtracted, the damped frequency staying. Modes of which more than a hundredth is cut
   off are said to be doubtful.
    @throws InputError  when a mode would not be damped without the window
    [worker] Docs/Theory.md, section 8.1. */
IdentifiedModes withoutRecordEffects (IdentifiedModes, const RecordEffects&);
} // namespace antinode
