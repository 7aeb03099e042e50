#include "Support/SinePlate.h"

#include <antinode_engine/AlignedBuffers.h>
#include <antinode_graph/SurfaceNode.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
constexpr double rate = 48000;
constexpr int modes = 20, length = 1200;

Eigen::MatrixXd shaking (Eigen::Index ceramics)
{
    Eigen::MatrixXd voltages (ceramics, length);

    for (Eigen::Index i = 0; i < ceramics; ++i)
        for (Eigen::Index n = 0; n < length; ++n)
            voltages (i, n) = std::sin (0.03 * static_cast<double> (n * (i + 1)));

    return voltages;
}

/** A node under voltages, in blocks. @return  probes x samples */
Eigen::MatrixXd played (SurfaceNode& node, const Eigen::MatrixXd& voltages, int block)
{
    const PlanarBuffer<double> in (node.inputs(), block), out (node.outputs(), block);
    Eigen::MatrixXd result (node.outputs(), voltages.cols());

    for (Eigen::Index start = 0; start < voltages.cols(); start += block)
    {
        const auto count = static_cast<int> (std::min<Eigen::Index> (block, voltages.cols() - start));

        for (int i = 0; i < node.inputs(); ++i)
            for (int n = 0; n < count; ++n)
                in.channel (static_cast<std::size_t> (i))[n] = voltages (i, start + n);

        node.process (NodeBlock { in.channels(), out.channels(), count, {} });

        for (int p = 0; p < node.outputs(); ++p)
            for (int n = 0; n < count; ++n)
                result (p, start + n) = out.channel (static_cast<std::size_t> (p))[n];
    }

    return result;
}

struct Example
{
    std::shared_ptr<const ModalModel> model = std::make_shared<const ModalModel> (test::SinePlate().model (modes));
    Eigen::MatrixXd here =
        (Eigen::MatrixXd (2, modes) << shapesAt (*model, 0.03, 0.02), shapesAt (*model, 0.05, 0.04)).finished();
    Eigen::MatrixXd voltages = shaking (model->actuators());
};
} // namespace

TEST_CASE ("The surface node gives what the plate model gives, for any blocks", "[graph]")
{
    const Example example;
    PlateModel plate (*example.model, { Reconstruction::bandLimited, rate }, example.here);
    Eigen::MatrixXd expected (2, length);
    plate.process (example.voltages, expected);

    for (const auto block : { 1, 8, 37, 1200 })
    {
        PlateModelNode node (example.model, example.here);
        node.prepare ({ rate, block });
        CHECK (node.latencySamples() == plate.latencySamples());
        const auto heard = played (node, example.voltages, block);
        CHECK ((heard - expected).cwiseAbs().maxCoeff() <= 1e-14 * expected.cwiseAbs().maxCoeff());
        std::vector<double> velocities (modes);
        node.modalVelocities (velocities);
        CHECK (Eigen::Map<Eigen::VectorXd> (velocities.data(), modes) == plate.modalVelocities());
    }
}

TEST_CASE ("Probes of the surface node move while the surface moves on", "[graph]")
{
    const Example example;
    const Eigen::MatrixXd there = example.here.colwise().reverse();
    PlateModelNode still (example.model, there), moved (example.model, example.here);
    still.prepare ({ rate, 64 });
    moved.prepare ({ rate, 64 });
    played (still, example.voltages, 64);
    played (moved, example.voltages, 64);

    for (int i = 0; i < 3; ++i)
    {
        moved.setProbes (i % 2 == 0 ? there : example.here);
        const Eigen::MatrixXd a = played (still, example.voltages, 64), b = played (moved, example.voltages, 64);
        CHECK (b == (i % 2 == 0 ? a : Eigen::MatrixXd (a.colwise().reverse())));
    }
}

TEST_CASE ("Both surface nodes move their modes alike", "[graph]")
{
    const Example example;
    PlateModelNode slow (example.model, example.here);
    PlateNode quick (example.model, example.here);
    std::vector<double> one (modes), other (modes);
    slow.prepare ({ rate, 64 });
    quick.prepare ({ rate, 64 });
    // What lags sees as many samples more.
    played (quick, example.voltages.leftCols (length - slow.latencySamples()), 64);
    played (slow, example.voltages, 64);
    slow.modalVelocities (one);
    quick.modalVelocities (other);
    const Eigen::Map<Eigen::VectorXd> a (one.data(), modes), b (other.data(), modes);
    CHECK (a.cwiseAbs().maxCoeff() > 0);
    CHECK ((a - b).cwiseAbs().maxCoeff() < 0.05 * a.cwiseAbs().maxCoeff());
}
