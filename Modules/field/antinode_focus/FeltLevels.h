#pragma once

#include "FocusDesign.h"

#include <functional>
#include <utility>
#include <vector>

namespace antinode
{
/** What a fingertip feels of a program from its begin to where the surface rests, dB SL, without a finger that changes
    the motion, unless the model has it.
    @param places    x, y, m
    @param duration  s, of the voltages from the trigger on; beyond it modes decay freely
    @return          as many levels as places
    @throws InputError  as renderOffline; Cancelled when a watch of this thread says no
    [worker] Docs/Theory.md, section 5.1. */
std::vector<double> feltLevels (const ModalModel&, const VoltageProgram&, Playback, double duration,
                                const std::vector<std::pair<double, double>>& places, const SkinThreshold&);

/** Whether a target is asked for by its level. [any] */
bool asksForLevels (const FocusDescription&);

/** Designs with the peak velocities that the levels of targets need: designed, played on the model, and corrected until
    each level is within .02 dB. A linear design needs two rounds.
    @param allocate  makes a design for velocities; the brake that it asks for is thought of
    @return          its description has velocities in place of levels
    @throws LimitError  for levels beyond the limits, with those that can be reached; InputError where targets keep each
    other from their levels
    [worker] Docs/Theory.md, section 5.1. */
FocusDesign designLevels (const ModalModel&, const FocusDescription&, Playback,
                          const std::function<FocusDesign (const FocusDescription&)>& allocate);
} // namespace antinode
