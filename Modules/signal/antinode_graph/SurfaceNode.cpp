#include "SurfaceNode.h"

#include <algorithm>
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

namespace
{
constexpr int tile = 16; // samples that are moved at once
} // namespace

PlateModelNode::PlateModelNode (std::shared_ptr<const ModalModel> modelToUse, Eigen::MatrixXd probeShapes)
    : model (std::move (modelToUse)), probes (static_cast<int> (probeShapes.rows())),
      shapes (std::make_unique<const Eigen::MatrixXd> (std::move (probeShapes)))
{
    requirePlayable (*model, *shapes);
}

PlateModelNode::~PlateModelNode()
{
    delete next.load();
    delete replaced.load();
}

void PlateModelNode::prepare (const NodeFormat& format)
{
    plate = std::make_unique<PlateModel> (*model, Playback { Reconstruction::bandLimited, format.sampleRate },
                                          Eigen::MatrixXd (0, model->coordinates()));
    voltages.setZero (model->actuators(), tile);
    motion.setZero (model->coordinates(), tile);
    heard.setZero (probes, tile);
}

void PlateModelNode::setProbes (Eigen::MatrixXd probeShapes)
{
    requirePlayable (*model, probeShapes);
    delete replaced.exchange (nullptr, std::memory_order_acq_rel);
    auto made = std::make_unique<const Eigen::MatrixXd> (std::move (probeShapes));
    delete next.exchange (made.release(), std::memory_order_acq_rel);
}

void PlateModelNode::takeProbes()
{
    // One that came back must have been freed before another may: until then the old places are looked at.
    if (replaced.load (std::memory_order_acquire) != nullptr)
        return;

    if (const auto* const taken = next.exchange (nullptr, std::memory_order_acq_rel))
    {
        replaced.store (shapes.release(), std::memory_order_release);
        shapes.reset (taken);
    }
}

void PlateModelNode::modalVelocities (std::span<double> velocities) const
{
    std::copy_n (plate->modalVelocities().data(), velocities.size(), velocities.data());
}

void PlateModelNode::process (const NodeBlock& block)
{
    takeProbes();

    for (int done = 0; done < block.count; done += tile)
    {
        const auto count = std::min (tile, block.count - done);

        for (int i = 0; i < inputs(); ++i)
            for (int n = 0; n < count; ++n)
                voltages (i, n) = block.inputs[i][done + n];

        plate->processModes (voltages.leftCols (count), motion.leftCols (count));

        for (int n = 0; n < count; ++n)
        {
            heard.col (n).setZero();

            for (Eigen::Index k = 0; k < motion.rows(); ++k)
                heard.col (n) += shapes->col (k) * motion (k, n);

            for (int p = 0; p < probes; ++p)
                block.outputs[p][done + n] = heard (p, n);
        }
    }
}
} // namespace antinode
