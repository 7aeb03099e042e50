#pragma once

#include "FocusDescription.h"
#include "FocusDesign.h"

#include <Eigen/Core>
#include <antinode_model/ModalModel.h>
#include <antinode_model/Surface.h>
#include <antinode_model/VoltageProgram.h>

#include <optional>
#include <vector>

namespace antinode
{
/** One target's profile: 1 at its centre, 1/2 at half its width.
    @param distance  m, from the centre, of either sign
    @param width     full width at half maximum, m
    [any] Docs/Theory.md, section 2.1; paper (34) for the bump. */
double targetProfile (TargetShape, double distance, double width);

/** The wanted velocity v* on the surface's points: the sum of all targets.
    @param edgeWindow  Tukey taper, the share of the surface's length that is tapered (half of it at either end where
   the edge is held; of a surface with a boundary that share of its shorter extent, along what holds it), or none
    @return            N_p values, m/s
    [any] Docs/Theory.md, section 2.1. */
Eigen::VectorXd targetField (const Surface&, const std::vector<Target>&, std::optional<double> edgeWindow);

/** The same at one place, on the surface's points or between them. m/s [any] */
double targetVelocity (const Surface&, const std::vector<Target>&, std::optional<double> edgeWindow, double x,
                       double y);

/** Peak over RMS, weighted by area, outside the focal spots: farther than a width from every target's centre, each axis
   in its own width. 0 where nothing lies outside or moves.
    @param field  N_p values, m/s
    @param peak   m/s, of either sign: what largestVelocity finds
    [any] Docs/Theory.md, section 5. */
double fieldContrast (const Surface&, const Eigen::VectorXd& field, const std::vector<Target>&, double peak);

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
