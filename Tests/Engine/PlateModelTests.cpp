#include "EngineFixtures.h"
#include "Support/AllocationCount.h"

#include <antinode_base/InputError.h>
#include <antinode_engine/PlateModel.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr auto byInterface = Reconstruction::bandLimited;
constexpr auto byGenerator = Reconstruction::zeroOrderHold;

Eigen::MatrixXd playInBlocks (PlateModel& plate, const Eigen::MatrixXd& voltages, Eigen::Index outputs,
                              Eigen::Index blockSize)
{
    Eigen::MatrixXd velocities (outputs, voltages.cols());
    for (Eigen::Index first = 0; first < voltages.cols(); first += blockSize)
    {
        const auto count = std::min (blockSize, voltages.cols() - first);
        plate.process (voltages.middleCols (first, count), velocities.middleCols (first, count));
    }
    return velocities;
}
} // namespace

TEST_CASE ("under a constant voltage every mode comes to rest at psi / omega^2")
{
    const auto model = modelWithModes ({ 400, 3000, 20e3, 70e3 }, 5, Eigen::Vector4d (1, -2, 3, 4));
    for (const auto reconstruction : { byGenerator, byInterface })
    {
        PlateModel plate (model, { reconstruction, 48e3 }, Eigen::MatrixXd::Ones (1, 4));
        const Eigen::MatrixXd voltages = Eigen::MatrixXd::Constant (1, 48000, 10.0);
        playInBlocks (plate, voltages, 1, 512);
        const Eigen::ArrayXd atRest =
            10 * model.participation.col (0).array() / model.angularFrequencies.array().square();
        // Interpolated samples of a constant ripple by 1e-6 at most: the images at the multiples of the sample rate.
        const auto tolerance = reconstruction == byGenerator ? 1e-12 : 1e-6;
        CHECK ((plate.modalDisplacements().array() / atRest - 1).abs().maxCoeff() < tolerance);
        CHECK ((plate.modalVelocities().array() / (atRest * model.angularFrequencies.array())).abs().maxCoeff()
               < tolerance);
    }
}

TEST_CASE ("a probe's velocity is the sum of shape times modal velocity")
{
    const auto model = manyModes();
    Draws draws (5);
    const Eigen::MatrixXd shapes = draws.matrix (3, 34), voltages = draws.matrix (8, 300);
    PlateModel plate (model, { byInterface, 48e3 }, shapes), other (model, { byInterface, 48e3 }, shapes);
    const auto velocities = playInBlocks (plate, voltages, 3, 300);
    Eigen::MatrixXd modal (34, 300);
    other.processModes (voltages, modal);
    CHECK ((shapes * modal - velocities).cwiseAbs().maxCoeff() < 1e-13 * velocities.cwiseAbs().maxCoeff());
    CHECK (sameBits (plate.modalVelocities(), modal.rightCols (1)));
    CHECK (sameBits (plate.modalDisplacements(), other.modalDisplacements()));
}

TEST_CASE ("plate velocities do not depend on the block size, to the bit, and reset starts anew")
{
    const auto model = manyModes();
    Draws draws (6);
    const Eigen::MatrixXd shapes = draws.matrix (3, 34), voltages = draws.matrix (8, 9000);
    for (const auto reconstruction : { byInterface, byGenerator })
    {
        PlateModel plate (model, { reconstruction, 192e3 }, shapes);
        const auto whole = playInBlocks (plate, voltages, 3, 9000);
        for (const auto blockSize : blockSizes)
        {
            plate.reset();
            CHECK (plate.modalVelocities().isZero (0));
            INFO ("blocks of " << blockSize);
            CHECK (sameBits (playInBlocks (plate, voltages, 3, blockSize), whole));
        }
    }
}

TEST_CASE ("the plate is linear and does not change with time")
{
    const auto model = manyModes();
    Draws draws (7);
    const Eigen::MatrixXd shapes = draws.matrix (2, 34), one = draws.matrix (8, 500), other = draws.matrix (8, 500);
    for (const auto rate : usualRates)
    {
        PlateModel plate (model, { byInterface, rate }, shapes);
        const auto play = [&] (const Eigen::MatrixXd& voltages)
        {
            plate.reset();
            return playInBlocks (plate, voltages, 2, 64);
        };
        const auto sum = play (2 * one - 3 * other);
        const Eigen::MatrixXd parts = 2 * play (one) - 3 * play (other);
        CHECK ((sum - parts).cwiseAbs().maxCoeff() < 1e-13 * sum.cwiseAbs().maxCoeff());

        Eigen::MatrixXd later = Eigen::MatrixXd::Zero (8, 541);
        later.rightCols (500) = one;
        const auto delayed = play (later);
        CHECK (delayed.leftCols (41).isZero (0));
        CHECK (sameBits (delayed.rightCols (500), play (one)));
    }
}

TEST_CASE ("a plate that is left alone becomes exactly still instead of denormal")
{
    PlateModel plate (modelWithModes ({ 500, 5000 }, 1, Eigen::Vector2d (1, 1)), { byInterface, 48e3 },
                      Eigen::MatrixXd::Ones (1, 2));
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (1, 20000);
    voltages (0, 0) = 100;
    const auto velocities = playInBlocks (plate, voltages, 1, 512);
    CHECK (velocities.cwiseAbs().maxCoeff() > 1e-4);
    CHECK ((velocities.array() == 0 || velocities.array().abs() > std::numeric_limits<double>::min()).all());
    CHECK (plate.modalVelocities().isZero (0));
    CHECK (plate.modalDisplacements().isZero (0));
}

TEST_CASE ("the plate model allocates nothing while it plays")
{
    PlateModel plate (manyModes(), { byInterface, 48e3 }, Draws (8).matrix (3, 34));
    const Eigen::MatrixXd voltages = Draws (9).matrix (8, 100);
    Eigen::MatrixXd velocities (3, 100), modal (34, 100);
    const auto before = mallocCalls();
    plate.process (voltages, velocities);
    plate.processModes (voltages, modal);
    plate.process (voltages.leftCols (0), velocities.leftCols (0));
    plate.reset();
    CHECK (mallocCalls() == before);
    CHECK ((! mallocIsCounted() || before > 0));
}

TEST_CASE ("a plate model needs a usable rate, sizes that agree and finite numbers")
{
    const auto model = manyModes();
    const Eigen::MatrixXd probe = Eigen::MatrixXd::Ones (1, 34);
    const auto infinite = std::numeric_limits<double>::infinity();
    for (const auto rate : { 0.0, -1.0, infinite, std::numeric_limits<double>::quiet_NaN(), 400.0 })
        CHECK_THROWS_AS (PlateModel (model, { byInterface, rate }, probe), InputError);

    const Playback playback { byInterface, 48e3 };
    CHECK_NOTHROW (PlateModel (model, playback, Eigen::MatrixXd (0, 34)));
    CHECK_THROWS_AS (PlateModel (model, playback, Eigen::MatrixXd::Ones (1, 33)), InputError);
    CHECK_THROWS_AS (PlateModel (model, playback, probe * infinite), InputError);

    auto broken = model;
    broken.participation (3, 3) = infinite;
    CHECK_THROWS_AS (PlateModel (broken, playback, probe), InputError);
    broken = model;
    broken.participation.conservativeResize (33, 8);
    CHECK_THROWS_AS (PlateModel (broken, playback, probe), InputError);
    broken = model;
    broken.dampingRatios[2] = 1;
    CHECK_THROWS_AS (PlateModel (broken, playback, probe), InputError);
    broken = model;
    broken.angularFrequencies[2] = 0;
    CHECK_THROWS_AS (PlateModel (broken, playback, probe), InputError);
}
