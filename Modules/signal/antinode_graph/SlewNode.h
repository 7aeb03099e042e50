#pragma once

#include "Node.h"

#include <antinode_engine/SlewLimiter.h>

#include <Eigen/Core>

#include <optional>

namespace antinode
{
/** Keeps slew rates, before a limiter. */
class SlewNode : public Node
{
public:
    /** @param limits  N_b, V
        @param slews   N_b, V/s; 0: none
        [worker] */
    SlewNode (Eigen::VectorXd limits, Eigen::VectorXd slews);

    std::string name() const override { return "Slew rates"; }
    int inputs() const override { return static_cast<int> (limits.size()); }
    int outputs() const override { return inputs(); }
    void prepare (const NodeFormat&) override;
    void process (const NodeBlock&) override;
    void reset() override;

private:
    Eigen::VectorXd limits, slews;
    std::optional<SlewLimiter> limiter; ///< None before prepare().
};
} // namespace antinode
