#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_model/ModalRecursion.h>
#include <antinode_model/VoltageProgram.h>

#include <Eigen/Core>

namespace antinode
{
/** The plate in time: sampled voltages in, modal state and probe velocities out.

    Integrates every mode exactly for the voltage that the samples stand for: held (zero-order hold), or band-limited
    (interpolated by a Kaiser-windowed sinc, then integrated over each sample to rounding). Each mode has a complex
   state y' = (-a + jb) y + psi, of which q = Im y / b and q' = Re y - (a/b) Im y; complex modes have complex forces
   psi, and also what moves the imaginary parts of their shapes. Knows nothing of how the voltages were designed. The
   output does not depend, to the bit, on how the samples are cut into blocks.

    The velocity of sample n is that of the time nT, before a held sample n acts. Samples before the first are 0.
    A voltage that is not finite stays in the state until reset: VoltageLimiter stands before this and lets none
   through. States and forces below 1e-200 become 0, so that no denormal numbers slow a silent plate down. Reference
   kernel: double precision, clear before fast. Docs/Theory.md, section 6.2.
*/
class PlateModel
{
public:
    /** @param probeShapes  N_probes x N_c: the rows of mode shapes at the probes (shapesAt), kg^-1/2
        @throws InputError  when the rate is not finite and positive or less than 1/64 of a mode's frequency, or sizes
       do not agree, or a number is not finite [worker] allocates */
    PlateModel (const ModalModel&, Playback, Eigen::MatrixXd probeShapes);

    /** The latency of the output in samples: the look-ahead of the interpolation, 15. 0 for zero-order hold. [any] */
    int latencySamples() const { return recursion.latency; }

    /** Takes a block of voltages and gives the probe velocities latencySamples() earlier.
        @param voltages    N_b x n, V
        @param velocities  N_probes x n, m/s
        [audio thread] allocates nothing, locks nothing, any n >= 0 */
    void process (Eigen::Ref<const Eigen::MatrixXd> voltages, Eigen::Ref<Eigen::MatrixXd> velocities);

    /** The same with the modal velocities q'_k themselves instead of the probes.
        @param voltages    N_b x n, V
        @param velocities  N_c x n, m/s kg^1/2
        [audio thread] allocates nothing, locks nothing, any n >= 0 */
    void processModes (Eigen::Ref<const Eigen::MatrixXd> voltages, Eigen::Ref<Eigen::MatrixXd> velocities);

    /** The modal velocities q'_k after the last processed sample (of the time latencySamples() before it), N_c. [audio
        thread] */
    const Eigen::VectorXd& modalVelocities() const { return velocity; }

    /** The modal displacements q_k of the same instant, N_c. [audio thread] */
    const Eigen::VectorXd& modalDisplacements() const { return displacement; }

    /** Back to rest. [audio thread] */
    void reset();

private:
    void pushForces (const Eigen::Ref<const Eigen::VectorXd>& voltages);
    void advance (const Eigen::Ref<const Eigen::VectorXd>& voltages);
    void addTurned();
    void takeDisplacements();

    ModalRecursion recursion;
    Eigen::MatrixXd participation; // N_c x N_b
    Eigen::MatrixXd probeShapes;
    Eigen::ArrayXd dampedFrequency, decayPerTurn; // b and a/b
    Eigen::ArrayXd stateReal, stateImaginary, turned;
    Eigen::ArrayXXd forces; // the last L forces, each twice, so that they lie in a row wherever the newest one is
    Eigen::Index newest = 0;
    Eigen::VectorXd velocity, displacement;
};
} // namespace antinode
