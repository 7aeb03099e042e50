#pragma once

#include "AlignedBuffers.h"
#include "PlateKernel.h"
#include "ProbeKernel.h"

#include <antinode_model/ModalModel.h>

#include <Eigen/Core>

#include <span>

namespace antinode
{
/** The plate in real time, for the monitor: planar voltages in, probe velocities out, without latency.

    Each mode's state y' = s y + psi goes over a sample with y_n = e^{sT} y_{n-1} + g psi_n, g = (2/a) tanh (aT/2), and
   its velocity is read in the middle of what the sample adds: half of psi_n counts, as at the edge of a trapezoid.
   Force that turns with the mode has its exact steady effect; force that turns w faster has it within (wT)^2 / 12. A
   mode of Q = 60 that is driven at its own frequency therefore moves as in PlateModel within 1e-3 of its peak up to a
   tenth of the sample rate. Modes above half of the rate would fold and are left out. For results there is PlateModel.

    The output does not depend, to the bit, on how the samples are cut into blocks. States below 1e-200 become 0, so
   that no denormal numbers slow a silent plate down. A voltage that is not finite stays in the state until reset:
   VoltageLimiter stands before this. Docs/Theory.md, section 6.5. */
class RealtimePlate
{
public:
    /** @param sampleRate   Hz
        @param probeShapes  N_probes x N_c: the rows of mode shapes at the probes (shapesAt), kg^-1/2
        @throws InputError  when the rate is not finite and positive, a mode is not usable, sizes do not agree, or a
       number is not finite [worker] allocates */
    RealtimePlate (const ModalModel&, double sampleRate, const Eigen::MatrixXd& probeShapes);

    /** Takes voltages and gives the probe velocities at the same samples.
        @param voltages    N_b pointers to count samples each, V
        @param velocities  N_probes pointers to count samples each, m/s
        @param count       at least 0
        [audio thread] allocates nothing, locks nothing */
    void process (const double* const* voltages, double* const* velocities, int count);

    /** Goes on from where another plate is, of the same model and rate, but with other probes. [audio thread] */
    void copyMotion (const RealtimePlate&);

    /** The modal velocities at the last sample; those that are left out are 0.
        @param velocities  room for N_c, m/s kg^1/2
        [audio thread] */
    void modalVelocities (std::span<double> velocities) const;

    /** Back to rest. [audio thread] */
    void reset();

private:
    void setTransitions (const ModalModel&, double sampleRate, Eigen::Index audible);
    void setDrive (Eigen::Index heard, const Eigen::RowVectorXd& perVolt);
    void setShapes (Eigen::Index heard, const Eigen::VectorXd& atProbes);
    void setModeShapes (Eigen::Index mode, const Eigen::MatrixXd& probeShapes);
    double atLastSample (std::size_t mode, int coordinate) const;

    AlignedVector<double> drive, transition, shapes;                   // as PlateTile has them
    AlignedVector<double> state, motion, sums, inputVoltages, outputs; // as PlateTile has them
    Eigen::VectorXd decayPerTurn;                                      // N_m: a/b
    PlateTile sizes;
    PlateKernel move;
    ProbeKernel probes;
    int position = 0; // in the tile: tiles do not begin where blocks do
    int newest = 0;   // the last sample in inputVoltages
};
} // namespace antinode
