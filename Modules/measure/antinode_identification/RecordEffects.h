#pragma once

#include "IdentifiedModes.h"

namespace antinode
{
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
