#pragma once

#include "Node.h"

#include <antinode_engine/RealtimePlate.h>

#include <memory>
#include <optional>

namespace antinode
{
/** The plate under the voltages: the velocity at each probe, a channel each, for a monitor. */
class PlateNode : public Node
{
public:
    /** @param probeShapes  N_probes x N_m: the rows of mode shapes at the probes (shapesAt), kg^-1/2 */
    PlateNode (std::shared_ptr<const ModalModel>, Eigen::MatrixXd probeShapes);

    std::string name() const override { return "Plate"; }
    int inputs() const override { return static_cast<int> (model->actuators()); }
    int outputs() const override { return static_cast<int> (probeShapes.rows()); }
    void prepare (const NodeFormat&) override;
    void process (const NodeBlock<float>&) override;
    void process (const NodeBlock<double>&) override;
    void reset() override;

private:
    std::shared_ptr<const ModalModel> model;
    Eigen::MatrixXd probeShapes;
    std::optional<RealtimePlate> plate;
};
} // namespace antinode
