#include "EngineFixtures.h"
#include "Support/HeldPlate.h"
#include "Support/ViscousChain.h"

#include <antinode_base/InputError.h>
#include <antinode_engine/PlateModel.h>
#include <antinode_engine/RealtimePlate.h>

#include <catch2/catch.hpp>
#include <hwy/targets.h>

#include <complex>

using namespace antinode;
using namespace antinode::test;

namespace
{
using Planar = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/** n modes of any complex shape: 34 are more than one group. */
ModalModel manyComplexModes (Eigen::Index modes)
{
    auto model = manyModes();
    Draws draws (51);
    model.angularFrequencies.conservativeResize (modes);
    model.dampingRatios.conservativeResize (modes);
    model.participation = draws.matrix (2 * modes, 8);
    return model;
}

Planar play (RealtimePlate& plate, const Planar& voltages, Eigen::Index probes, int blockSize)
{
    Planar velocities (probes, voltages.cols());

    for (int first = 0; first < voltages.cols(); first += blockSize)
    {
        std::vector<const double*> in;
        std::vector<double*> out;

        for (Eigen::Index i = 0; i < voltages.rows(); ++i)
            in.push_back (&voltages (i, first));

        for (Eigen::Index p = 0; p < probes; ++p)
            out.push_back (&velocities (p, first));

        plate.process (in.data(), out.data(), std::min (blockSize, static_cast<int> (voltages.cols()) - first));
    }

    return velocities;
}

/** The recursion by its definition, with complex numbers in extended precision: probes and, at the end, N_c velocities.
 */
std::pair<Eigen::MatrixXd, Eigen::VectorXd>
byDefinition (const ModalModel& model, double rate, const Eigen::MatrixXd& shapes, const Eigen::MatrixXd& voltages)
{
    using Complex = std::complex<long double>;
    const auto modes = model.modes();
    Eigen::MatrixXd velocities = Eigen::MatrixXd::Zero (shapes.rows(), voltages.cols());
    Eigen::VectorXd last (2 * modes);

    for (Eigen::Index k = 0; k < modes; ++k)
    {
        const long double a = decayRates (model)[k], b = dampedFrequencies (model)[k],
                          interval = 1 / static_cast<long double> (rate);
        const auto z = std::exp (Complex (-a, b) * interval);
        const auto half = std::tanh (a * interval / 2) / a;
        Complex y = 0;

        for (Eigen::Index n = 0; n < voltages.cols(); ++n)
        {
            const Complex force (model.participation.row (k).dot (voltages.col (n)),
                                 model.participation.row (modes + k).dot (voltages.col (n)));
            y = z * y + half * force;
            const auto velocity = Complex (1, a / b) * y;

            for (Eigen::Index p = 0; p < shapes.rows(); ++p)
                velocities (p, n) +=
                    static_cast<double> ((Complex (shapes (p, k), shapes (p, modes + k)) * velocity).real());

            last[k] = static_cast<double> (velocity.real());
            last[modes + k] = -static_cast<double> (velocity.imag());
            y += half * force;
        }
    }

    return { velocities, last };
}
} // namespace

TEST_CASE ("The plate model moves a chain with complex modes as held voltages do, to 1e-9", "[engine][complex]")
{
    constexpr auto rate = 48000.0;
    const auto chain = viscousChain (12, 4, 40);
    const auto model = complexModel (chain);
    const Eigen::MatrixXd voltages = Draws (52).matrix (4, 600);
    PlateModel plate (model, { Reconstruction::zeroOrderHold, rate }, model.shapes);
    Eigen::MatrixXd velocities (12, 600);
    plate.process (voltages, velocities);

    Eigen::MatrixXd generator = Eigen::MatrixXd::Zero (28, 28);
    generator.topLeftCorner (24, 24) = chain.stateMatrix() / rate;
    generator.topRightCorner (24, 4) = chain.inputMatrix() / rate;
    const Eigen::MatrixXd step = exponential (generator);
    Eigen::VectorXd state = Eigen::VectorXd::Zero (24);
    Eigen::MatrixXd wanted (12, 600);

    for (Eigen::Index n = 0; n < 600; ++n)
    {
        wanted.col (n) = state.tail (12);
        state = (step.topLeftCorner (24, 24) * state + step.topRightCorner (24, 4) * voltages.col (n)).eval();
    }

    CHECK ((velocities - wanted).norm() / wanted.norm() <= 1e-9);
    const Eigen::VectorXd displacement = model.shapes * plate.modalDisplacements();
    CHECK ((model.shapes * plate.modalVelocities() - wanted.col (599)).norm() / wanted.col (599).norm() <= 1e-9);
    CHECK (displacement.allFinite());
}

TEST_CASE ("The real-time plate follows its recursion with complex modes to 1e-12, with every instruction set",
           "[engine][complex]")
{
    for (const auto modes : { 3, 34 })
        for (const auto probes : { 0, 1, 7, 16 })
        {
            const auto model = manyComplexModes (modes);
            Draws draws (53);
            const Eigen::MatrixXd shapes = draws.matrix (probes, 2 * modes), voltages = draws.matrix (8, 1000);
            const auto [wanted, last] = byDefinition (model, 96e3, shapes, voltages);

            for (const auto target : hwy::SupportedAndGeneratedTargets())
            {
                hwy::SetSupportedTargetsForTest (target);
                RealtimePlate plate (model, 96e3, shapes);
                hwy::SetSupportedTargetsForTest (0);
                const Planar velocities = play (plate, voltages, probes, 1000);
                std::vector<double> ends (static_cast<std::size_t> (2 * modes));
                plate.modalVelocities (ends);
                INFO (hwy::TargetName (target) << ", " << modes << " modes, " << probes << " probes");
                CHECK ((velocities - wanted).norm() <= 1e-12 * wanted.norm());
                CHECK ((Eigen::Map<Eigen::VectorXd> (ends.data(), 2 * modes) - last).norm() <= 1e-12 * last.norm());
            }
        }
}

TEST_CASE ("Velocities of complex modes do not depend on the block size, to the bit", "[engine][complex]")
{
    const auto model = manyComplexModes (34);
    Draws draws (54);
    const Eigen::MatrixXd shapes = draws.matrix (3, 68);
    const Planar voltages = draws.matrix (8, 700);
    RealtimePlate plate (model, 192e3, shapes);
    const auto whole = play (plate, voltages, 3, 700);

    for (const auto blockSize : { 1, 7, 16, 100 })
    {
        plate.reset();
        CHECK (play (plate, voltages, 3, blockSize) == whole);
    }
}

TEST_CASE ("Shapes at probes need both parts of complex modes", "[engine][complex]")
{
    const auto model = manyComplexModes (3);
    CHECK_THROWS_AS (RealtimePlate (model, 48e3, Eigen::MatrixXd::Ones (1, 3)), InputError);
    CHECK_THROWS_AS (PlateModel (model, { Reconstruction::bandLimited, 48e3 }, Eigen::MatrixXd::Ones (1, 3)),
                     InputError);
    CHECK_NOTHROW (RealtimePlate (model, 48e3, Eigen::MatrixXd::Ones (1, 6)));
}
