#pragma once

#include "Node.h"

#include <Eigen/Core>

namespace antinode
{
/** Voltages that no amplifier could follow follow as quickly as it can. It stands before the limiter, which has the
   last word, and goes hardly beyond a limit, so that it does not take longer to come back. */
class SlewNode : public Node
{
public:
    /** @param limits  N_b, V
        @param slews   N_b, V/s; 0: none
        [worker] */
    SlewNode (const Eigen::VectorXd& limits, Eigen::VectorXd slews);

    std::string name() const override { return "Slew rates"; }
    int inputs() const override { return static_cast<int> (limits.size()); }
    int outputs() const override { return inputs(); }
    void prepare (const NodeFormat&) override;
    void process (const NodeBlock<float>&) override;
    void process (const NodeBlock<double>&) override;
    void reset() override { last.setZero(); }

private:
    template <typename Sample>
    void follow (const NodeBlock<Sample>&);

    Eigen::VectorXd limits, slews;
    Eigen::VectorXd steps; ///< V from sample to sample.
    Eigen::VectorXd last;  ///< V
};
} // namespace antinode
