#pragma once

#include "LearningPasses.h"

#include <string>
#include <vector>

namespace antinode
{
/** Why no design can be made of what was learnt, a sentence; empty: one can.
    @param pass  the last one
    [any] Docs/Theory.md, section 7.6. */
std::string doubtOf (const LearningPass& pass, const LearntModes& learnt, const ModalModel& nominal,
                     const ModeSpread& deviations);

/** Why what was learnt is not used after all plays, a sentence; empty: it is. [any] */
std::string refusalOf (const LearntFocus&, const ModalModel& nominal, const ModeSpread& deviations);

/** Why what is used may still be wrong, a sentence; empty: nothing is known against it. [any] */
std::string warningOf (const LearntFocus&);

/** Whether so much stays unexplained or a frequency is moved so far, that the fit may be in the wrong minimum.
    @param settledMove  in deviations: a frequency that is moved about so far is no sign of it any more
    [any] */
bool isStuck (const LearntModes&, double settledMove = 0);

/** Whether a play was predicted three times worse than by the nominal model, and what was learnt from it is stuck too:
    no more is played then. [any] */
bool isMisled (const LearningPass&, const LearntModes& learnt);

/** The play that was predicted best by what it was designed with: its field is nearest to what was wanted. The first
    one, where none was predicted much better. [any] */
std::size_t bestPredicted (const std::vector<LearningPass>&);
} // namespace antinode
