#include "EngineFixtures.h"
#include "Support/AllocationCount.h"

#include <antinode_base/InputError.h>
#include <antinode_engine/PlateModel.h>
#include <antinode_engine/RealtimePlate.h>

#include <catch2/catch.hpp>
#include <hwy/targets.h>

#include <algorithm>
#include <complex>
#include <limits>

using namespace antinode;
using namespace antinode::test;

namespace
{
using Planar = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/** Velocities under voltages that are handed over in blocks. */
Planar plateInBlocks (RealtimePlate& plate, const Planar& voltages, Eigen::Index probes, int blockSize)
{
    Planar velocities (probes, voltages.cols());
    std::vector<const double*> in (static_cast<std::size_t> (voltages.rows()));
    std::vector<double*> out (static_cast<std::size_t> (probes));

    for (int first = 0; first < voltages.cols(); first += blockSize)
    {
        for (std::size_t i = 0; i < in.size(); ++i)
            in[i] = &voltages (static_cast<Eigen::Index> (i), first);

        for (std::size_t p = 0; p < out.size(); ++p)
            out[p] = &velocities (static_cast<Eigen::Index> (p), first);

        plate.process (in.data(), out.data(), std::min (blockSize, static_cast<int> (voltages.cols()) - first));
    }

    return velocities;
}

/** The recursion by the definition, with complex numbers in extended precision. */
Eigen::MatrixXd byDefinition (const ModalModel& model, double rate, const Eigen::MatrixXd& shapes,
                              const Eigen::MatrixXd& voltages)
{
    using Complex = std::complex<long double>;
    Eigen::MatrixXd velocities = Eigen::MatrixXd::Zero (shapes.rows(), voltages.cols());
    const auto decay = decayRates (model), turn = dampedFrequencies (model);

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        const long double a = decay[k], b = turn[k], interval = 1 / static_cast<long double> (rate);
        const auto z = std::exp (Complex (-a, b) * interval);
        const auto gain = 2 / a * std::tanh (a * interval / 2);
        Complex y = 0;

        for (Eigen::Index n = 0; n < voltages.cols(); ++n)
        {
            const long double force = model.participation.row (k).dot (voltages.col (n));
            y = z * y + gain / 2 * force;
            velocities.col (n) += shapes.col (k) * static_cast<double> (y.real() - a / b * y.imag());
            y += gain / 2 * force;
        }
    }

    return velocities;
}
} // namespace

TEST_CASE ("the real-time plate follows its recursion to 1e-12, with every instruction set")
{
    const auto model = manyModes();
    Draws draws (21);

    for (const auto probes : { 0, 1, 7, 16 })
    {
        const Eigen::MatrixXd shapes = draws.matrix (probes, 34), voltages = draws.matrix (8, 3000);
        const auto wanted = byDefinition (model, 96e3, shapes, voltages);

        for (const auto target : hwy::SupportedAndGeneratedTargets())
        {
            hwy::SetSupportedTargetsForTest (target);
            RealtimePlate plate (model, 96e3, shapes);
            hwy::SetSupportedTargetsForTest (0);
            const Eigen::MatrixXd velocities = plateInBlocks (plate, voltages, probes, 3000);
            INFO (hwy::TargetName (target) << ", " << probes << " probes");
            CHECK ((velocities - wanted).norm() <= 1e-12 * wanted.norm());
        }
    }
}

TEST_CASE ("modes driven at resonance, to a tenth of the rate, move as in the exact plate within 1e-3 of the peak")
{
    const auto rate = 192e3;

    for (const auto frequency : { 400.0, 5e3, 19.2e3 })
    {
        const auto model = modelWithModes ({ 0.7 * frequency, frequency }, 60, Eigen::Vector2d (0, 1)); // one is driven
        const Eigen::MatrixXd probe = Eigen::MatrixXd::Ones (1, 2);
        RealtimePlate fast (model, rate, probe);
        PlateModel exact (model, { Reconstruction::bandLimited, rate }, probe);
        Eigen::MatrixXd voltages (1, 40000), wanted (1, 40000);

        for (Eigen::Index n = 0; n < voltages.cols(); ++n)
            voltages (0, n) = std::sin (dampedFrequencies (model)[1] * static_cast<double> (n) / rate);

        exact.process (voltages, wanted);
        const auto latency = exact.latencySamples();
        const Eigen::MatrixXd velocities = plateInBlocks (fast, voltages, 1, 512);
        const auto compared = voltages.cols() - latency;
        const auto error = (velocities.leftCols (compared) - wanted.rightCols (compared)).cwiseAbs().maxCoeff();
        INFO (frequency << " Hz");
        CHECK (error < 1e-3 * wanted.cwiseAbs().maxCoeff());
    }
}

TEST_CASE ("real-time velocities do not depend on the block size, to the bit, and reset starts anew")
{
    const auto model = manyModes();
    Draws draws (22);
    const Eigen::MatrixXd shapes = draws.matrix (3, 34);
    const Planar voltages = draws.matrix (8, 9000);
    RealtimePlate plate (model, 192e3, shapes);
    const auto whole = plateInBlocks (plate, voltages, 3, 9000);

    for (const auto blockSize : blockSizes)
    {
        INFO ("blocks of " << blockSize);
        plate.reset();
        CHECK (plateInBlocks (plate, voltages, 3, blockSize) == whole);
    }
}

TEST_CASE ("a real-time plate that is left alone becomes exactly still instead of denormal")
{
    RealtimePlate plate (modelWithModes ({ 500, 5000 }, 1, Eigen::Vector2d (1, 1)), 48e3, Eigen::MatrixXd::Ones (1, 2));
    Planar voltages = Planar::Zero (1, 20000);
    voltages (0, 0) = 100;
    const auto velocities = plateInBlocks (plate, voltages, 1, 512);
    CHECK (velocities.cwiseAbs().maxCoeff() > 1e-4);
    CHECK ((velocities.array() == 0 || velocities.array().abs() > std::numeric_limits<double>::min()).all());
    CHECK (velocities.rightCols (100).isZero (0));
}

TEST_CASE ("modes above half of the rate are left out of the real-time plate instead of folded")
{
    const auto model = modelWithModes ({ 5e3, 40e3 }, 60, Eigen::Vector2d (1, 1));
    const Planar voltages = Draws (23).matrix (1, 500);
    RealtimePlate both (model, 48e3, Eigen::RowVector2d (1, 1)), one (model, 48e3, Eigen::RowVector2d (1, 0));
    CHECK (plateInBlocks (both, voltages, 1, 500) == plateInBlocks (one, voltages, 1, 500));
}

TEST_CASE ("the real-time plate allocates nothing while it plays")
{
    RealtimePlate plate (manyModes(), 48e3, Draws (24).matrix (3, 34));
    std::vector<double> silence (800), velocity (300);
    const double* in[8] = {};
    std::fill_n (in, 8, silence.data());
    double* out[3] = { velocity.data(), velocity.data() + 100, velocity.data() + 200 };
    const auto before = mallocCalls();
    plate.process (in, out, 100);
    plate.process (in, out, 0);
    plate.reset();
    CHECK (mallocCalls() == before);
    CHECK ((! mallocIsCounted() || before > 0));
}

TEST_CASE ("a real-time plate needs a usable rate, sizes that agree and finite numbers")
{
    const auto model = manyModes();
    const Eigen::MatrixXd probe = Eigen::MatrixXd::Ones (1, 34);
    const auto infinite = std::numeric_limits<double>::infinity();
    CHECK_NOTHROW (RealtimePlate (model, 48e3, probe));
    CHECK_THROWS_AS (RealtimePlate (model, 0, probe), InputError);
    CHECK_THROWS_AS (RealtimePlate (model, infinite, probe), InputError);
    CHECK_THROWS_AS (RealtimePlate (model, 48e3, probe.leftCols (33)), InputError);
    CHECK_THROWS_AS (RealtimePlate (model, 48e3, probe * infinite), InputError);
    auto broken = model;
    broken.participation (3, 3) = infinite;
    CHECK_THROWS_AS (RealtimePlate (broken, 48e3, probe), InputError);
}
