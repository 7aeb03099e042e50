#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_model/VoltageProgram.h>

#include <Eigen/Core>

namespace antinode::test
{
/** Masses on springs and dampers: M w'' + C w' + K w = B u, with any C. Clamped at both ends. */
struct ViscousChain
{
    Eigen::MatrixXd mass, damping, stiffness; ///< n x n
    Eigen::MatrixXd forces;                   ///< n x N_b, N/V

    Eigen::Index size() const { return mass.rows(); }

    /** 1/s: displacements are counted in w' / rate, so that both halves of the state are of one size. */
    static constexpr double rate = 1e4;

    /** d/dt (rate w, w') = A (rate w, w') + (0, M^-1 B u) */
    Eigen::MatrixXd stateMatrix() const;
    Eigen::MatrixXd inputMatrix() const;
};

/** Eight to twelve masses, 0.7 to 4 kHz, with dampers in two places that no proportional damping could be.
    @param damper  N s/m; 0: proportional damping only, so that the modes are real */
ViscousChain viscousChain (Eigen::Index size, Eigen::Index ceramics, double damper);

/** Its modes from the eigenvectors of the state matrix, psi' (2 s M + C) psi = 2 j Im (s), as the model wants them. */
ModalModel complexModel (const ViscousChain&);

/** (w, w') of the chain at a time under a program, continuous voltages, from the matrix exponential of chain and
    oscillations together, from one begin or end of an oscillation to the next: no modes. */
Eigen::VectorXd chainMotion (const ViscousChain&, const VoltageProgram&, double time);
} // namespace antinode::test
