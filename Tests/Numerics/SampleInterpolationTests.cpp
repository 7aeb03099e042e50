#include <antinode_numerics/KaiserSinc.h>
#include <antinode_numerics/Statistics.h>

#include <catch2/catch.hpp>

#include <numbers>

using namespace antinode;

TEST_CASE ("What is interpolated goes through its samples, and through a tone between them",
           "[numerics][interpolation]")
{
    constexpr Eigen::Index samples = 120, factor = 4;
    const auto tone = [] (double sample) { return std::sin (2 * std::numbers::pi * 0.2 * sample); };
    Eigen::MatrixXd signal (samples, 1);

    for (Eigen::Index n = 0; n < samples; ++n)
        signal (n, 0) = tone (static_cast<double> (n));

    const auto between = interpolated (signal, factor);
    REQUIRE (between.rows() == (samples - 1 + 2 * kaiserSincHalfWidth) * factor + 1);

    for (Eigen::Index n = 0; n < samples; ++n)
        CHECK (between ((n + kaiserSincHalfWidth) * factor, 0) == Approx (signal (n, 0)).margin (1e-12));

    // Away from both ends, where the tone begins and stops.
    for (Eigen::Index m = 40 * factor; m < 80 * factor; ++m)
        CHECK (between (m + kaiserSincHalfWidth * factor, 0)
               == Approx (tone (static_cast<double> (m) / factor)).margin (3 * kaiserSincPassBandError));
}

TEST_CASE ("The adjoint of interpolation has its inner products", "[numerics][interpolation]")
{
    RandomNumbers random (5);

    for (const Eigen::Index factor : { 1, 2, 5 })
    {
        constexpr Eigen::Index samples = 17;
        const Eigen::MatrixXd signal = random.normal (samples);
        const auto played = interpolated (signal, factor);
        const Eigen::MatrixXd values = random.normal (played.rows());
        CHECK (interpolationAdjoint (values, factor).col (0).dot (signal.col (0))
               == Approx (values.col (0).dot (played.col (0))));
    }
}
