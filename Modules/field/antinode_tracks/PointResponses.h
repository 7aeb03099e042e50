#pragma once

#include <antinode_model/ModalModel.h>

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** What rests on the surface at one place: a force -(mass a + damping v + stiffness w) on its motion. */
struct SurfaceLoad
{
    Eigen::RowVectorXd shapes;                   ///< N_m, kg^-1/2, of the place.
    double mass = 0, damping = 0, stiffness = 0; ///< kg, N s/m, N/m
};

/** Displacement at points for voltages, at the lines of a discrete Fourier transform. */
struct PointResponses
{
    Eigen::Index points = 0, actuators = 0;
    Eigen::Index length = 0; ///< Of the transform, samples.
    double sampleRate = 0;   ///< Hz
    Eigen::MatrixXcd values; ///< (length / 2 + 1) x (points actuators): column p + points i, m/V.

    /** The responses of all points, one a row, to all ceramics at one line. */
    Eigen::MatrixXcd atLine (Eigen::Index line) const;
};

/** The responses of a surface with real modes, and what rests on it, exactly: each load adds a term of rank one to the
    modal equations, which Sherman and Morrison's identity takes into account line by line.
    @param pointShapes  points x N_m, kg^-1/2
    @throws InputError  when the modes are complex
    [worker] Docs/Theory.md, section 4.13. */
PointResponses pointResponses (const ModalModel&, const Eigen::MatrixXd& pointShapes,
                               const std::vector<SurfaceLoad>& loads, double sampleRate, Eigen::Index length);
} // namespace antinode
