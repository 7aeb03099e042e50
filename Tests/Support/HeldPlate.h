#pragma once

#include <antinode_fingers/LoadedModel.h>

#include <vector>

namespace antinode::test
{
/** The exponential of a square matrix, by Taylor's series of a small part of it and squaring. */
Eigen::MatrixXd exponential (const Eigen::MatrixXd&);

/** The plate with fingers as M, C and K, and what it does from one held sample to the next, by the exponential of its
   whole first-order matrix: no modes of it are used. */
struct HeldPlate
{
    HeldPlate (const ModalModel& bare, const std::vector<Finger>& fingers, double interval);

    /** The velocities after a sample through which a force was held. */
    Eigen::VectorXd after (const Eigen::VectorXd& force);

    Eigen::Index count;
    Eigen::MatrixXd step;
    Eigen::VectorXd state;
};
} // namespace antinode::test
