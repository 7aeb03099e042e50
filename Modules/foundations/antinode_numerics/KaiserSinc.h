#pragma once

#include <Eigen/Core>

namespace antinode
{
/** Samples to each side that the interpolation reaches. */
inline constexpr int kaiserSincHalfWidth = 16;

/** Kaiser's shape parameter, no unit. 12 is where pass band and accuracy balance for this half-width, see kaiserSinc.
 */
inline constexpr double kaiserSincShape = 12;

/** The part of the Nyquist frequency up to which a tone comes through as it is, within kaiserSincPassBandError. */
inline constexpr double kaiserSincPassBand = 0.75;

/** Bound, in the pass band, on the error of the gain and on the size of each image, both relative to the tone. */
inline constexpr double kaiserSincPassBandError = 2e-6;

/** The interpolation of a band-limited playback: sinc (x) I0 (beta sqrt (1 - (x/M)^2)) / I0 (beta), M = 16, beta = 12.

    1 at 0, 0 at all other integers, 0 from M on. Up to 0.75 of the Nyquist frequency the gain is 1 within 2e-6 and each
    image is below 2e-6; at the Nyquist frequency the gain is 1/2.
    @param x  in samples
    [worker] Kaiser and Schafer, IEEE Transactions on Acoustics, Speech and Signal Processing 28 (1980) 105.
   Docs/Theory.md, section 6.2. */
double kaiserSinc (double x);

/** The same with another half-width and shape: shorter kernels have less delay and a wider transition.
    @param x          in samples
    @param halfWidth  in samples, above 0
    @param shape      Kaiser's beta, no unit
    [worker] */
double kaiserSinc (double x, double halfWidth, double shape);

/** Signals at a rate that is a whole multiple of theirs: what their samples stand for, from kaiserSincHalfWidth samples
    before the first one to as many behind the last.
    @param signals  N_s x any number, one a column
    @param factor   at least 1
    @return         (N_s - 1 + 2 kaiserSincHalfWidth) factor + 1 samples each
    [worker] */
Eigen::MatrixXd interpolated (const Eigen::MatrixXd& signals, Eigen::Index factor);

/** The adjoint of interpolated(): what values for each sample of its result are for each sample that it is made from.
    @param values  (N_s - 1 + 2 kaiserSincHalfWidth) factor + 1 x any number, one a column
    @param factor  at least 1
    @return        N_s x as many
    [worker] */
Eigen::MatrixXd interpolationAdjoint (const Eigen::MatrixXd& values, Eigen::Index factor);
} // namespace antinode
