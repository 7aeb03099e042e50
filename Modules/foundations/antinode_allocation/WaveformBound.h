#pragma once

#include "MinimumPeak.h"

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** Modal velocities to be reached from rest, by voltages of any waveform. N_k modes, N_b ceramics. */
struct WaveformBoundProblem
{
    Eigen::VectorXcd poles;        ///< N_k: s_k = -a_k + j b_k, 1/s, a_k >= 0, b_k > 0.
    Eigen::MatrixXd participation; ///< N_k x N_b, N kg^-1/2 / V.
    Eigen::VectorXd wanted;        ///< N_k: q'_k at the end, m/s kg^1/2.
    Eigen::VectorXd voltageLimits; ///< N_b, V, more than 0.
    double duration = 0;           ///< t_f, s, more than 0.
};

/** The voltage of one ceramic, held from edge to edge. */
struct HeldWaveform
{
    Eigen::VectorXd edges;  ///< N_n + 1, s before the end, ascending from 0 to the duration.
    Eigen::VectorXd ratios; ///< N_n: voltage / limit from edges (n) to edges (n + 1).
};

/** Both sides of the least max |u_i (t)| / voltageLimits (i) over all waveforms that bring the wanted velocities. */
struct WaveformBound
{
    double lower = 0;                    ///< Certified: no waveform needs less.
    double upper = 0;                    ///< What the waveform below needs; infinite where none was found.
    double gap = 0;                      ///< (upper - lower) / upper, 0 to 1; 1 where no waveform was found.
    std::vector<HeldWaveform> waveforms; ///< N_b: they reach the wanted velocities. None where none was found.
};

/** The gap that is asked for, and above which a design warns. */
inline constexpr double waveformBoundTolerance = 0.005;

/** A certified lower bound of max |u_i (t)| / voltageLimits (i) over all waveforms on [0, t_f] that bring the modes
   from rest to the wanted velocities, and a waveform that comes close to it. With h_k (tau) = e^{-a tau} (cos b tau -
   a/b sin b tau), the velocity after an impulse, and any y

        max |u_i| / limit_i >= sum_k wanted_k y_k / sum_i limit_i integral_0^t_f |f_i|,   f_i (tau) = sum_k y_k
   participation_ki h_k (tau)

    y are the multipliers of the least peak of voltages that are held from edge to edge (MinimumPeak.h), whose
   velocities are closed forms. Cells in which f_i changes its sign are split until both sides are within 0.5 %, as far
   as memory (1 GiB) lets them. The integrals are bounded from above: Taylor polynomials of f_i with the most that they
   can miss, so the bound holds for the continuous waveform.
    @return  0 on both sides where nothing is wanted; look at gap
    @throws InputError  when sizes or numbers are not usable, or no ceramic moves a wanted mode
    [worker] Docs/Theory.md, section 4.5. */
WaveformBound anyWaveformPeakBound (const WaveformBoundProblem&);

/** Voltages that are held from edge to edge, each ceramic's edges its own, and the velocities that they bring: over a
   cell integral h_k = g_k (end) - g_k (start) with g_k (tau) = e^{-a tau} sin (b tau) / b. [worker] */
class HeldCells
{
public:
    /** 6 cells a cycle of the fastest mode that is not yet decayed by 60 dB, at least 32, fewer than 1 GiB of weights.
     */
    explicit HeldCells (const WaveformBoundProblem&);

    /** The rows of one volt-limit: participation times limit times integral. */
    MinimumPeakProblem problem() const;

    /** Splits cells in which sum_k y_k participation_ki h_k changes its sign, so that what they lose stays below a part
       of the price; hands the samples on.
        @return  false where nothing is to be gained or memory is full */
    bool split (MinimumPeak&, double part);

    std::vector<HeldWaveform> waveforms (const Eigen::VectorXd& samples) const;

private:
    struct Ceramic
    {
        Eigen::VectorXd edges, gains;
        std::shared_ptr<const Eigen::MatrixXd> weights;
    };

    Eigen::MatrixXd computeWeights (const Eigen::VectorXd& edges) const;

    Eigen::VectorXcd poles;
    Eigen::VectorXd wanted;
    std::vector<Ceramic> ceramics;
};

/** An upper bound of sum_i limit_i integral_0^t_f |f_i|, f_i (tau) = sum_k y_k participation_ki h_k (tau).

    Cell by cell, f_i is its Taylor polynomial of degree 7 around the middle and a remainder of at most
    (step/2)^8 / 8! sum_k |y_k participation_ki c_k s_k^8| e^{-a tau}; cells are so short that all remainders together
   are 1e-5 of the whole. Where a polynomial surely keeps its sign it is integrated, elsewhere chords of sixteenths of
   the cell with the most that they can miss. Rounding of the sums is added.
    @param about  the value, roughly: what the remainders are measured with
    [worker] Docs/Theory.md, section 4.5. */
double waveformPrice (const WaveformBoundProblem&, const Eigen::VectorXd& y, double about);
} // namespace antinode
