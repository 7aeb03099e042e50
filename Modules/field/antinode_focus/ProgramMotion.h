#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_model/Oscillation.h>

#include <Eigen/Core>

#include <vector>

namespace antinode
{
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
} // namespace antinode
