#pragma once

#include "Node.h"

#include <Eigen/Core>

#include <span>

namespace antinode
{
/** A node that moves a surface: voltages in, the velocity at each probe out. */
class SurfaceNode : public Node
{
public:
    /** Looks at other places from the next block on; the surface goes on moving.
        @param probeShapes  as many rows as before, kg^-1/2
        @throws InputError  when sizes do not agree
        [worker, one at a time, not during prepare] allocates */
    virtual void setProbes (Eigen::MatrixXd probeShapes) = 0;

    /** How the modes move just now. @param velocities  room for N_c, m/s kg^1/2 [audio thread, not before prepare] */
    virtual void modalVelocities (std::span<double> velocities) const = 0;
};
} // namespace antinode
