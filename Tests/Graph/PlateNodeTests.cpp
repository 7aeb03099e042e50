#include "Support/SinePlate.h"

#include <antinode_engine/AlignedBuffers.h>
#include <antinode_graph/SurfaceNode.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
/** Voltages that shake every mode, in blocks of 37 samples. @return  the velocity at each probe, block by block */
std::vector<double> play (PlateNode& node, int blocks, int firstBlock)
{
    constexpr int length = 37;
    const PlanarBuffer<double> voltages (node.inputs(), length), velocities (node.outputs(), length);
    std::vector<double> played;

    for (int b = firstBlock; b < firstBlock + blocks; ++b)
    {
        for (int i = 0; i < node.inputs(); ++i)
            for (int n = 0; n < length; ++n)
                voltages.channel (i)[n] = std::sin (0.03 * (b * length + n) * (i + 1));

        node.process (NodeBlock { voltages.channels(), velocities.channels(), length, {} });

        for (int p = 0; p < node.outputs(); ++p)
            played.insert (played.end(), velocities.channel (p), velocities.channel (p) + length);
    }

    return played;
}
} // namespace

TEST_CASE ("Probes that move leave the plate moving as it did", "[graph]")
{
    const auto model = std::make_shared<const ModalModel> (test::SinePlate().model (20));
    const Eigen::MatrixXd here =
        (Eigen::MatrixXd (2, 20) << shapesAt (*model, 0.03, 0.02), shapesAt (*model, 0.05, 0.04)).finished();
    const Eigen::MatrixXd there = here.colwise().reverse();
    PlateNode still (model, here), moved (model, here), swapped (model, there);

    for (auto* const node : { &still, &moved, &swapped })
    {
        node->prepare ({ 48000, 64 });
        play (*node, 11, 0);
    }

    moved.setProbes (here);
    CHECK (play (moved, 5, 11) == play (still, 5, 11));
    moved.setProbes (there);
    play (swapped, 5, 11);
    CHECK (play (moved, 5, 16) == play (swapped, 5, 16));
}
