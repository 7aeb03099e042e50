#pragma once

#include <Eigen/Core>
#include <antinode_model/ModalModel.h>
#include <antinode_model/VoltageProgram.h>

#include <complex>
#include <vector>

namespace antinode
{
/** The state y of a mode under one oscillation, in closed form: y' = s y + value (t), y = 0 before; s = -a + j b.
    q = Im (y) / b, q' = Re[(1 + j a/b) y].
    @param pole  s, 1/s
    @param time  s, from the trigger; after the oscillation's end the mode decays freely
    @return      y, exact for any growth, also at p = s
    [any] Docs/Theory.md, section 3.1. */
std::complex<double> modalResponse (std::complex<double> pole, const Oscillation&, double time);

/** The same for the oscillation played as samples on a grid through `focusTime` and held between them.
    @param time  s; a time of the grid
    [any] Docs/Theory.md, section 6.3. */
std::complex<double> heldModalResponse (std::complex<double> pole, const Oscillation&, double time, double sampleRate);

/** The poles s_k = -a_k + j b_k of all modes, 1/s. [any] */
Eigen::VectorXcd modalPoles (const ModalModel&);

/** Velocity and displacement from states.
    @param states  y_k of all modes
    @return        N_c: of complex modes those that move the imaginary parts of the shapes behind the others
    [any] Docs/Theory.md, sections 1.11 and 3.1. */
Eigen::VectorXd modalVelocities (const ModalModel&, const Eigen::VectorXcd& states);
Eigen::VectorXd modalDisplacements (const ModalModel&, const Eigen::VectorXcd& states);

/** The states of all modes at one time under a whole program, for the continuous voltages.
    @param time  s from the trigger
    @return      N_m values y_k
    [worker] Docs/Theory.md, section 3.1. */
Eigen::VectorXcd predictStates (const ModalModel&, const VoltageProgram&, double time);

/** Forces on all modes as complex numbers: of complex modes the imaginary parts lie behind the real ones.
    @param forces  N_c x any: participation times voltages
    @return        N_m x any
    [any] Docs/Theory.md, section 1.11. */
Eigen::MatrixXcd complexForces (const ModalModel&, const Eigen::MatrixXd& forces);

/** The value of an oscillation at one time: for start <= t < end, else 0. [any] */
double oscillationValue (const Oscillation&, double time);

/** The motion of all modes under a program, prepared for many times: what is free at all begins and ends of
   oscillations is kept, so that a time costs only what plays then. Docs/Theory.md, section 3.1. */
class ProgramMotion
{
public:
    /** [worker] */
    ProgramMotion (const ModalModel&, const VoltageProgram&);

    /** As predictStates: N_m values y_k. [worker] */
    Eigen::VectorXcd statesAt (double time) const;

    /** When the first oscillation begins and the last one ends, s from the trigger. [any] */
    double first() const { return knots.front().time; }
    double last() const { return knots.back().time; }

private:
    /** From one begin or end to the next. */
    struct Knot
    {
        double time = 0;
        Eigen::VectorXcd free;             // free decay from here on, in addition to what plays
        std::vector<Eigen::Index> playing; // oscillations
    };

    Eigen::VectorXcd forced (Eigen::Index oscillation, double time) const;
    Knot knotAfter (const Knot&, double time) const;

    Eigen::VectorXcd poles;
    std::vector<Oscillation> oscillations;
    Eigen::MatrixXcd with,
        against; // N_m x oscillations: X / (2 (p - s)) and its counterpart of conj (p), times the modal force
    std::vector<Knot> knots;
};

/** The states y of modes at the instant of one sample per unit of modal force in each sample, exact for the playback: a
   held sample in closed form, a band-limited one by the integral of its kernel up to that instant.
    @param samples  N_s, how many there are
    @param focus    which of them the instant is that of, counted from 0; it may lie beyond them
    @return         modes x N_s, s
    [worker] Docs/Theory.md, sections 4.9 and 6.2. */
Eigen::MatrixXcd sampleResponses (const ModalModel&, const std::vector<int>& modes, Playback, Eigen::Index samples,
                                  Eigen::Index focus);

/** The voltages that samples stand for at any time, N_b. [any] Docs/Theory.md, section 6.2. */
Eigen::VectorXd voltagesAt (const SampledVoltages&, double time);

/** The states of all modes at any time under sampled voltages.
    @param time  s from the trigger
    @return      N_m values y_k
    [worker] Docs/Theory.md, section 4.9. */
Eigen::VectorXcd sampledStates (const ModalModel&, const SampledVoltages&, double time);

/** The largest voltage between the samples as well, searched at 8 instants per sample. V [worker] */
double intersamplePeak (const SampledVoltages&);
} // namespace antinode
