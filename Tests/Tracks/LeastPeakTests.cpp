#include "Support/SmallWindow.h"

#include <antinode_tracks/LeastPeak.h>
#include <antinode_tracks/TrackSolver.h>

#include <catch2/catch.hpp>

#include <Eigen/Dense>

#include <cmath>

using namespace antinode;

namespace
{
/** The least ||G u - w|| / ||w|| within a limit, by Beck and Teboulle's accelerated projected gradients on the dense
    matrix: no dual, no compliance. */
double leastErrorWithin (const Eigen::MatrixXd& normal, const Eigen::VectorXd& right, double square, double step,
                         const Eigen::VectorXd& bounds)
{
    Eigen::VectorXd u = Eigen::VectorXd::Zero (right.size()), ahead = u;
    double momentum = 1;

    for (int i = 0; i < 3000; ++i)
    {
        const Eigen::VectorXd next = (ahead - step * (normal * ahead - right)).cwiseMin (bounds).cwiseMax (-bounds);
        const auto more = (1 + std::sqrt (1 + 4 * momentum * momentum)) / 2;
        ahead = next + (momentum - 1) / more * (next - u);
        u = next;
        momentum = more;
    }

    return std::sqrt (std::max (0.0, u.dot (normal * u) - 2 * right.dot (u) + square) / square);
}
} // namespace

TEST_CASE ("The least peak that leaves an error is that of projected gradients on the dense matrix", "[tracks]")
{
    namespace small = test::small_window;
    constexpr double error = 0.05;
    auto responses = small::someWindow();
    const auto wanted = small::someWanted();
    const Eigen::VectorXd limits = Eigen::Vector4d (1, 1.5, 0.7, 1.2);
    auto found = softestPeak (responses, wanted, limits, error);
    const auto softest = found.peak;

    for (int i = 0; i < 6 && found.peak > 1.02 * found.bound; ++i)
    {
        found = lowerPeak (responses, wanted, limits, error, found);
        CHECK (found.error <= error);
        CHECK (found.bound <= found.peak);
        CHECK ((found.voltages.cwiseAbs() * limits.cwiseInverse().asDiagonal()).maxCoeff() <= found.peak * (1 + 1e-12));
    }

    CHECK (found.peak <= 1.02 * found.bound);
    CHECK (found.peak < 0.9 * softest);
    CHECK (responses.compliance() == small::compliance);

    const auto dense = small::denseResponses (responses);
    CHECK ((dense * found.voltages.reshaped() - wanted.reshaped()).norm() <= error * wanted.norm() * (1 + 1e-9));
    const Eigen::MatrixXd normal = dense.transpose() * dense;
    const Eigen::VectorXd right = dense.transpose() * wanted.reshaped();
    const auto step = 1 / normal.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff();
    const Eigen::VectorXd bounds = limits.transpose().replicate (small::window, 1).reshaped();
    const auto leastError = [&] (double peak)
    { return leastErrorWithin (normal, right, wanted.squaredNorm(), step, peak * bounds); };
    CHECK (leastError (0.99 * found.bound) > error);
    CHECK (leastError (1.01 * found.peak) < error);
}
