#pragma once

#include "Waveforms.h"

#include <Eigen/Core>
#include <antinode_model/ModalModel.h>

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

/** What rests on the surface at the touched points. [worker] */
std::vector<SurfaceLoad> touchedLoads (const ModalModel&, const WaveformsDescription&);

/** Checks that there are no more touched points than ceramics: the surface can move so many each in its own way.
    @throws InputError  how many there are, and how many are allowed
    [any] */
void requireEnoughCeramics (const ModalModel&, const WaveformsDescription&);

/** Checks that no two touched points are so near to each other, at places every 3 mm of their ways, that over most of
   the band they move alike to within 5 %.
    @throws InputError  naming the points, their distance and the least that is allowed; as requirePlaces
    @throws Cancelled   when a watch of this thread says no
    [worker] */
void requireDistinctPoints (const ModalModel&, const WaveformsDescription&);

/** What the responses of all points of a device share, computed once, so that those of a few points take a millisecond:
    resonances at the lines up to a frequency, and modes far above it as a power series. */
class ResponseTable
{
public:
    /** @param inputs      N_m x N_i, N kg^-1/2 / V: participation of whatever is played, in place of the ceramics'
        @param sampleRate  Hz
        @param length      of the transform, samples
        @param highest     Hz: lines beyond it are 0
        @throws InputError  when the modes are complex
        [worker] Docs/Theory.md, section 4.16. */
    ResponseTable (const ModalModel&, Eigen::MatrixXd inputs, double sampleRate, Eigen::Index length, double highest);

    /** As pointResponses, to 1e-4 of the largest, on the thread that calls.
        @param pointShapes  points x N_m, kg^-1/2
        [worker] */
    PointResponses responses (const Eigen::MatrixXd& pointShapes, const std::vector<SurfaceLoad>& loads) const;

private:
    Eigen::MatrixXd strengths (const Eigen::RowVectorXd& shapes, const Eigen::MatrixXd& allInputs) const;

    Eigen::MatrixXd inputs;
    double sampleRate;
    Eigen::Index length;
    Eigen::MatrixXd real, imaginary; // lines x (resonances + terms)
    Eigen::MatrixXd series;          // terms x modes far above: each mode's coefficients of powers of j omega
};
} // namespace antinode
