#include "PlateNode.h"

#include <utility>

namespace antinode
{
PlateNode::PlateNode (std::shared_ptr<const ModalModel> modelToUse, Eigen::MatrixXd probeShapesToUse)
    : model (std::move (modelToUse)), probeShapes (std::move (probeShapesToUse))
{
}

PlateNode::~PlateNode()
{
    delete next.load();
    delete replaced.load();
}

void PlateNode::prepare (const NodeFormat& format)
{
    sampleRate = format.sampleRate;
    plate = std::make_unique<RealtimePlate> (*model, sampleRate, probeShapes);
    delete next.exchange (nullptr);
}

void PlateNode::setProbes (Eigen::MatrixXd shapes)
{
    probeShapes = std::move (shapes);
    delete replaced.exchange (nullptr, std::memory_order_acq_rel);
    auto made = std::make_unique<RealtimePlate> (*model, sampleRate, probeShapes);
    delete next.exchange (made.release(), std::memory_order_acq_rel);
}

RealtimePlate& PlateNode::newestPlate()
{
    // One that came back must have been freed before another may: until then the old places are looked at.
    if (replaced.load (std::memory_order_acquire) == nullptr)
    {
        if (auto* const taken = next.exchange (nullptr, std::memory_order_acq_rel))
        {
            taken->copyMotion (*plate);
            replaced.store (plate.release(), std::memory_order_release);
            plate.reset (taken);
        }
    }

    return *plate;
}

void PlateNode::process (const NodeBlock& block)
{
    newestPlate().process (block.inputs, block.outputs, block.count);
}

void PlateNode::reset()
{
    plate->reset();
}
} // namespace antinode
