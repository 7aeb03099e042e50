#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_model/Oscillation.h>

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace antinode
{
/** The state y of a mode under one oscillation, in closed form: y' = s y + value (t), y = 0 before; s = -a + j b.
    q = Im (y) / b, q' = Re[(1 + j a/b) y].
    @param pole  s, 1/s
    @param time  s, from the trigger; after the oscillation's end the mode decays freely
    @return      y, exact for any growth, also at p = s
    [any] Docs/Theory.md, section 3.1. */
std::complex<double> modalResponse (std::complex<double> pole, const Oscillation&, double time);

/** The same for the oscillation played as samples on a grid through `focusTime` and held between them.
    @param time  s; a time of the grid
    [any] Docs/Theory.md, section 6.3. */
std::complex<double> heldModalResponse (std::complex<double> pole, const Oscillation&, double time, double sampleRate);

/** The poles s_k = -a_k + j b_k of all modes, 1/s. [any] */
Eigen::VectorXcd modalPoles (const ModalModel&);

/** Velocity and displacement from states.
    @param states  y_k of all modes
    @return        N_c: of complex modes those that move the imaginary parts of the shapes behind the others
    [any] Docs/Theory.md, sections 1.11 and 3.1. */
Eigen::VectorXd modalVelocities (const ModalModel&, const Eigen::VectorXcd& states);
Eigen::VectorXd modalDisplacements (const ModalModel&, const Eigen::VectorXcd& states);

/** The states of all modes at one time under a whole program, for the continuous voltages.
    @param time  s from the trigger
    @return      N_m values y_k
    [worker] Docs/Theory.md, section 3.1. */
Eigen::VectorXcd predictStates (const ModalModel&, const VoltageProgram&, double time);

/** Forces on all modes as complex numbers: of complex modes the imaginary parts lie behind the real ones.
    @param forces  N_c x any: participation times voltages
    @return        N_m x any
    [any] Docs/Theory.md, section 1.11. */
Eigen::MatrixXcd complexForces (const ModalModel&, const Eigen::MatrixXd& forces);

/** The value of an oscillation at one time: for start <= t < end, else 0. [any] */
double oscillationValue (const Oscillation&, double time);
} // namespace antinode
