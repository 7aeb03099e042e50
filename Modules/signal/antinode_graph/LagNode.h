#pragma once

#include "Node.h"

#include <antinode_engine/LagFilters.h>

#include <memory>

namespace antinode
{
/** Undoes or applies what ceramics lag, one filter a ceramic. */
class LagNode : public Node
{
public:
    LagNode (std::shared_ptr<const ModalModel>, LagDirection);

    std::string name() const override { return "Lags"; }
    int inputs() const override { return static_cast<int> (model->actuators()); }
    int outputs() const override { return inputs(); }
    void prepare (const NodeFormat&) override;
    void process (const NodeBlock&) override;
    void reset() override { recent.setZero(); }
    std::int64_t latencySamples() const override { return filters.lateness; }

private:
    std::shared_ptr<const ModalModel> model;
    LagDirection direction;
    LagFilters filters;
    Eigen::MatrixXd recent; ///< Samples x N_b: those before the block that are still needed, then the block.
};
} // namespace antinode
