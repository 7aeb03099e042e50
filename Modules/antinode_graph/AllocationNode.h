#pragma once

#include "Node.h"

#include <Eigen/Core>

namespace antinode
{
/** Shares force oscillations out among ceramics: channel i is the sum of allocation (i, c) times input c, in that order. */
class AllocationNode : public Node
{
public:
    /** @param allocation  N_b x oscillations, V */
    explicit AllocationNode (Eigen::MatrixXd allocation);

    std::string name() const override { return "Allocation"; }
    int inputs() const override { return static_cast<int> (allocation.cols()); }
    int outputs() const override { return static_cast<int> (allocation.rows()); }
    void prepare (const NodeFormat&) override {}
    void process (const NodeBlock<float>&) override;
    void process (const NodeBlock<double>&) override;
    void reset() override {}

private:
    template <typename Sample>
    void mix (const NodeBlock<Sample>&) const;

    Eigen::MatrixXd allocation;
};
} // namespace antinode
