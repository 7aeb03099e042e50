#include "PlateNode.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

    // The plate's states pass through what floats cannot hold long before they are still: that must not slow down what comes behind.
    for (int i = 0; i < outputs(); ++i)
        std::replace_if (
            block.outputs[i], block.outputs[i] + block.count,
            [] (float velocity) { return std::abs (velocity) < std::numeric_limits<float>::min(); }, 0.0F);
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
