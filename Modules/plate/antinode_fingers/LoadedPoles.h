#pragma once

#include <Eigen/Core>

#include <complex>

namespace antinode
{
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
