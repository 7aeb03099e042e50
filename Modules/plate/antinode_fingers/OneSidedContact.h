#pragma once

#include "Finger.h"

#include <antinode_model/ModalModel.h>
#include <antinode_model/Playback.h>

namespace antinode
{
/** What the contact of a finger did over an event. */
struct ContactHistory
{
    int lifts = 0;         ///< How often the surface left the finger.
    double liftedTime = 0; ///< s, in all.
};

/** The motion of a surface under fingers that may lift off. */
struct ContactMotion
{
    Eigen::MatrixXd modalVelocities;       ///< N_m x N_s, m/s kg^1/2: at the samples, before a held one acts.
    std::vector<ContactHistory> histories; ///< One for each finger.
};

/** Whether any of them lifts off where the surface pulls away. [any] */
bool canLiftOff (const std::vector<Finger>&);

/** Plays voltages on a surface whose fingers push, but do not pull. A finger moves with the surface while the force
    between them, its static one included, is above 0; else it moves by itself on its own spring and damper until the
    surface meets it again, without rebound. Every mode and finger is exact within steps that are short beside the
    highest mode's period; forces of contact are even within a step, and meetings are found to rounding.
    @param model     with real modes, without the fingers
    @param voltages  N_b x N_s, V; 0 before the first sample, the last one after it
    @throws InputError  when modes are complex, fingers are not usable, or lighter than 0.001 g
    @throws Cancelled   when a watch of this thread says no
    [worker] Docs/Theory.md, section 1.12. */
ContactMotion motionUnderFingers (const ModalModel& model, const std::vector<Finger>& fingers, Playback playback,
                                  const Eigen::MatrixXd& voltages);
} // namespace antinode
