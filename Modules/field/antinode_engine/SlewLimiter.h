#pragma once

#include <Eigen/Core>

namespace antinode
{
/** Voltages that no amplifier could follow follow as quickly as it can. It stands before a limiter, which has the last
   word, and goes hardly beyond a limit, so that it does not take longer to come back. */
class SlewLimiter
{
public:
    /** @param limits      N_b, V
        @param slews       N_b, V/s; 0: none
        @param sampleRate  Hz
        [worker] */
    SlewLimiter (const Eigen::VectorXd& limits, const Eigen::VectorXd& slews, double sampleRate);

    /** What is not finite stays as it is, for the limiter to find. Inputs and outputs may be the same.
        @param inputs, outputs  N_b pointers to count samples each, V
        [audio thread] allocates nothing, locks nothing */
    void process (const double* const* inputs, double* const* outputs, int count);

    /** From 0 V on. [audio thread] */
    void reset() { last.setZero(); }

private:
    Eigen::VectorXd limits;
    Eigen::VectorXd steps; ///< V from sample to sample.
    Eigen::VectorXd last;  ///< V
};
} // namespace antinode
