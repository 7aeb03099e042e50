#pragma once

#include "FocusDesign.h"

#include <antinode_model/ModalModel.h>
#include <antinode_model/Playback.h>

#include <vector>

namespace antinode
{
/** When the first and the last focus of a description are, s from the trigger. [any] */
double earliestFocusTime (const FocusDescription&);
double latestFocusTime (const FocusDescription&);

/** The times of moments. [any] */
std::vector<double> momentTimes (const std::vector<FocusMoment>&);

/** The targets by their times, each time with its wanted field; times after the first fall on samples counted from it,
   so that the fields can be looked at there and held samples have exact rows. Modes are not chosen yet.
    @throws InputError  when a time has no field on the surface, or several times are asked of a method that has no
   exact rows [worker] Docs/Theory.md, section 4.11. */
std::vector<FocusMoment> focusMoments (const ModalModel&, const FocusDescription&, Playback);

/** Chooses the controlled modes for all moments together, and gives each the part that they represent: a count takes
   those with most energy over all of them, a share captured holds for each.
    @return  the modes, ascending
    @throws InputError  as selectModes
    [worker] Docs/Theory.md, sections 2.3 and 4.11. */
std::vector<int> controlModes (const ModalModel&, const ModeChoice&, std::vector<FocusMoment>&);
} // namespace antinode
