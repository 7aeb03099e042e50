#pragma once

#include "PointResponses.h"

#include <antinode_model/ModalModel.h>

#include <Eigen/Core>

#include <vector>

namespace antinode
{
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
