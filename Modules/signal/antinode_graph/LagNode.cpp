#include "LagNode.h"

#include <algorithm>
#include <utility>

namespace antinode
{
LagNode::LagNode (std::shared_ptr<const ModalModel> modelToUse, LagDirection directionToUse)
    : model (std::move (modelToUse)), direction (directionToUse)
{
}

void LagNode::prepare (const NodeFormat& format)
{
    filters = lagFilters (*model, format.sampleRate, direction);
    recent = Eigen::MatrixXd::Zero (filters.reach() + format.longestBlock, model->actuators());
}

void LagNode::process (const NodeBlock& block)
{
    const auto taps = filters.taps.rows(), before = filters.reach();

    for (Eigen::Index i = 0; i < recent.cols(); ++i)
    {
        auto samples = recent.col (i);
        std::copy (block.inputs[i], block.inputs[i] + block.count, samples.data() + before);
        const auto oldest = before + 1 - taps - filters.starts[static_cast<std::size_t> (i)];

        for (int n = 0; n < block.count; ++n)
            block.outputs[i][n] = filters.taps.col (i).dot (samples.segment (oldest + n, taps));

        std::copy (samples.data() + block.count, samples.data() + block.count + before, samples.data());
    }
}
} // namespace antinode
