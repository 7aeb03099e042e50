#pragma once

#include "Finger.h"

#include <Eigen/Core>
#include <antinode_model/ModalModel.h>

#include <complex>

namespace antinode
{
/** The mode shapes under a finger, averaged over the part of its contact that lies on the surface: even pressure.
    @return  N_c, kg^-1/2
    @throws InputError  when its middle lies outside the surface
    [worker] Docs/Theory.md, section 1.12. */
Eigen::RowVectorXd contactShapes (const ModalModel&, const Finger&);

/** A surface with fingers on it, as its own exact modes: complex ones, since fingers damp where they are. It takes the
    modes of the model, of a free one with its motion as a rigid body, and answers every voltage as these modes with the
   fingers' masses, dampers and springs in M, C and K do. A motion that a finger damps so strongly that it does not
   oscillate is two modes with damping ratios just below 1. Without fingers the model itself.
    @param model  with real modes
    @throws InputError  when the modes are complex, the size of shapes is not known, or fingers are not usable
    [worker] Docs/Theory.md, section 1.12. */
ModalModel loadedModel (const ModalModel& model, const std::vector<Finger>& fingers);

/** Modes that fingers couple: M = 1 + P m P', C = diag (2 a) + P c P', K = diag (a^2 + b^2) + P k P'. */
struct LoadedModes
{
    Eigen::VectorXd decay, frequency;         ///< N: a and b of the modes without fingers, 1/s and rad/s.
    Eigen::MatrixXd contacts;                 ///< N x F: P, the shapes under each finger.
    Eigen::VectorXd mass, damping, stiffness; ///< F: m, c, k in SI units.
};

/** All 2 N poles: the s with det (M s^2 + C s + K) = 0, in no order, real ones among them with an imaginary part of 0.
    By Ehrlich's and Aberth's simultaneous iteration on the determinant of F x F that is left of it.
    @throws std::runtime_error  when the iteration does not converge
    [worker] Docs/Theory.md, section 1.12. */
Eigen::VectorXcd loadedPoles (const LoadedModes&);

/** The vector of a pole: x with (M s^2 + C s + K) x = 0, as coordinates of the modes without fingers, its largest part
   1. [worker] */
Eigen::VectorXcd loadedVector (const LoadedModes&, std::complex<double> pole);

/** x' (2 s M + C) x: what the response x x' / that / (p - s) of a pole is divided by. [worker] */
std::complex<double> poleNorm (const LoadedModes&, std::complex<double> pole, const Eigen::VectorXcd& vector);
} // namespace antinode
