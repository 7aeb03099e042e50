#pragma once

#include "LowerBound.h"

namespace antinode
{
/** An upper bound of sum_i limit_i integral_0^t_f |f_i|, f_i (tau) = sum_k y_k participation_ki h_k (tau).

    Cell by cell, f_i is its Taylor polynomial of degree 7 around the middle and a remainder of at most
    (step/2)^8 / 8! sum_k |y_k participation_ki c_k s_k^8| e^{-a tau}; cells are so short that all remainders together
   are 1e-5 of the whole. Where a polynomial surely keeps its sign it is integrated, elsewhere chords of sixteenths of
   the cell with the most that they can miss. Rounding of the sums is added.
    @param about  the value, roughly: what the remainders are measured with
    [worker] Docs/Theory.md, section 4.5. */
double waveformPrice (const WaveformBoundProblem&, const Eigen::VectorXd& y, double about);
} // namespace antinode
