#include "EngineFixtures.h"

#include <antinode_base/InputError.h>
#include <antinode_engine/VoltageLimiter.h>

#include <catch2/catch.hpp>
#include <hwy/targets.h>

#include <algorithm>
#include <limits>

using antinode::InputError;
using antinode::VoltageLimiter;

namespace
{
const double notANumber = std::numeric_limits<double>::quiet_NaN();
const double infinite = std::numeric_limits<double>::infinity();
} // namespace

TEST_CASE ("samples within the limit pass unchanged and samples beyond it are clamped and counted")
{
    VoltageLimiter limiter (Eigen::Vector2d (10, 20));
    Eigen::MatrixXd voltages (2, 4);
    voltages << 10, -10, 10.5, -1e300, //
        20, 20.0000001, -15, -21;
    limiter.process (voltages);

    Eigen::MatrixXd wanted (2, 4);
    wanted << 10, -10, 10, -10, //
        20, 20, -15, -20;
    CHECK (voltages == wanted);
    CHECK (limiter.limitedSamples() == std::vector<std::int64_t> { 2, 2 });
    CHECK_FALSE (limiter.isMuted());
}

TEST_CASE ("a sample that is not finite mutes all ceramics from there on until reset")
{
    for (const auto bad : { notANumber, infinite, -infinite })
    {
        VoltageLimiter limiter (Eigen::Vector2d (10, 10));
        Eigen::MatrixXd voltages = Eigen::MatrixXd::Constant (2, 5, 3.0);
        voltages (1, 2) = bad;
        limiter.process (voltages);
        CHECK ((voltages.leftCols (2).array() == 3.0).all());
        CHECK ((voltages.rightCols (3).array() == 0.0).all());
        CHECK (limiter.isMuted());

        Eigen::MatrixXd later = Eigen::MatrixXd::Constant (2, 3, 30.0);
        limiter.process (later);
        CHECK ((later.array() == 0.0).all());
        CHECK (limiter.limitedSamples() == std::vector<std::int64_t> { 0, 0 });

        limiter.reset();
        later.setConstant (30.0);
        limiter.process (later);
        CHECK ((later.array() == 10.0).all());
        CHECK_FALSE (limiter.isMuted());
        CHECK (limiter.limitedSamples() == std::vector<std::int64_t> { 3, 3 });
    }
}

TEST_CASE ("a ceramic with a limit of 0 V gets nothing")
{
    VoltageLimiter limiter (Eigen::Vector2d (0, 1));
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Constant (2, 3, -0.5);
    limiter.process (voltages);
    CHECK ((voltages.row (0).array() == 0.0).all());
    CHECK ((voltages.row (1).array() == -0.5).all());
    CHECK (limiter.limitedSamples() == std::vector<std::int64_t> { 3, 0 });
}

TEST_CASE ("the limiter needs limits that are finite and not negative")
{
    CHECK_THROWS_AS (VoltageLimiter (Eigen::Vector2d (10, -1)), InputError);
    CHECK_THROWS_AS (VoltageLimiter (Eigen::Vector2d (10, notANumber)), InputError);
    CHECK_THROWS_AS (VoltageLimiter (Eigen::Vector2d (10, infinite)), InputError);
}

TEST_CASE ("planar channels are limited as a matrix is, in any blocks, with any instruction set")
{
    antinode::test::Draws draws (31);
    const Eigen::MatrixXd voltages = 20 * draws.matrix (3, 1200);
    const Eigen::Vector3d limits (5, 10, 19);

    for (const auto mutedFrom : { 0, 700, 1200 })
    {
        Eigen::MatrixXd wanted = voltages;
        if (mutedFrom < 1200)
            wanted (1, mutedFrom) = notANumber;
        const Eigen::MatrixXd given = wanted;
        VoltageLimiter whole (limits);
        whole.process (wanted);
        CHECK (wanted.rightCols (1200 - mutedFrom).isZero (0));
        CHECK (whole.isMuted() == (mutedFrom < 1200));

        for (const auto target : hwy::SupportedAndGeneratedTargets())
        {
            for (const auto blockSize : { 1, 7, 64, 512, 8193 })
            {
                hwy::SetSupportedTargetsForTest (target);
                VoltageLimiter limiter (limits);
                hwy::SetSupportedTargetsForTest (0);
                Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> planar = given;

                for (int first = 0; first < 1200; first += blockSize)
                {
                    double* channels[] = { &planar (0, first), &planar (1, first), &planar (2, first) };
                    limiter.process (channels, std::min (blockSize, 1200 - first));
                }

                INFO (hwy::TargetName (target) << ", blocks of " << blockSize);
                CHECK (antinode::test::sameBits (planar, wanted));
                CHECK (limiter.limitedSamples() == whole.limitedSamples());
                CHECK (limiter.isMuted() == whole.isMuted());
            }
        }
    }
}
