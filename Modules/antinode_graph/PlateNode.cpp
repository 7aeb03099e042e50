#include "PlateNode.h"

namespace antinode
{
PlateNode::PlateNode (std::shared_ptr<const ModalModel> modelToUse, Eigen::MatrixXd probeShapesToUse)
    : model (std::move (modelToUse)), probeShapes (std::move (probeShapesToUse))
{
}

void PlateNode::prepare (const NodeFormat& format)
{
    plate.emplace (*model, format.sampleRate, probeShapes);
}

void PlateNode::process (const NodeBlock<float>& block)
{
    plate->process (block.inputs, block.outputs, block.count);
}

void PlateNode::process (const NodeBlock<double>& block)
{
    plate->process (block.inputs, block.outputs, block.count);
}

void PlateNode::reset()
{
    plate->reset();
}
} // namespace antinode
