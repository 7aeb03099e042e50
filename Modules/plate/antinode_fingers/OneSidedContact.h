#pragma once

#include "Finger.h"

#include <antinode_model/ModalModel.h>
#include <antinode_model/VoltageProgram.h>

#include <vector>

namespace antinode
{
/** A surface by its modes, and fingers that touch it. */
struct ContactBodies
{
    Eigen::ArrayXcd poles;                    ///< N_m: s = -a + jb
    Eigen::ArrayXd decayPerTurn, turn;        ///< N_m: a/b and b, rad/s
    Eigen::MatrixXd contacts;                 ///< N_f x N_m: mode shapes under the fingers, kg^-1/2
    Eigen::MatrixXcd velocityRows, placeRows; ///< N_f x N_m: the real part of these times the state
    std::vector<Finger> fingers;
    Eigen::VectorXd pressing; ///< N_f: static forces, N; infinite where a finger cannot lift off
};

/** The state of all bodies. */
struct ContactState
{
    Eigen::VectorXcd modes;   ///< N_m: y, with q' = Re y - (a/b) Im y and q = Im y / b
    Eigen::Matrix2Xd fingers; ///< N_f columns: displacement m, velocity m/s
    std::vector<bool> isTouching;
};

/** What a step of a duration does to all bodies. */
struct ContactStep
{
    double duration = 0;              ///< s
    Eigen::ArrayXcd transition, gain; ///< N_m: e^{sh} and its integral
    Eigen::MatrixXd velocityPerForce; ///< N_f x N_f: of the surface at its end, by an even force
    std::vector<Eigen::Matrix2d> fingerTransition;
    std::vector<Eigen::Vector2d> fingerGain;
};

/** @throws InputError  when a finger is lighter than 0.001 g [worker] */
ContactBodies contactBodies (const ModalModel&, const std::vector<Finger>&);

/** All at rest and touching. [worker] */
ContactState restingState (const ContactBodies&);

/** @param duration  s [worker] */
ContactStep contactStep (const ContactBodies&, double duration);

/** The state after a step under even modal forces: fingers that touch move with the surface at its end, and lift off
    where that would need them to pull. @param forces  N_m, N kg^-1/2 [worker] */
ContactState moved (const ContactBodies&, const ContactStep&, const ContactState&, const Eigen::VectorXd& forces);

/** A finger meets the surface: the least impulses after which all that touch move together. [worker] */
void meet (const ContactBodies&, ContactState&, int finger);

/** N_f: displacements of the surface under the fingers, m. [worker] */
Eigen::VectorXd surfacePlaces (const ContactBodies&, const ContactState&);

/** N_m: q', m/s kg^1/2. [worker] */
Eigen::VectorXd modalVelocities (const ContactBodies&, const ContactState&);

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
