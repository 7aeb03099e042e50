#include "Support/SmallWindow.h"

#include <antinode_numerics/Statistics.h>
#include <antinode_tracks/TrackSolver.h>

#include <catch2/catch.hpp>

#include <Eigen/Dense>

using namespace antinode;
using namespace antinode::test::small_window;

TEST_CASE ("The pulls of multipliers are the transpose of the motion by voltages", "[tracks]")
{
    auto responses = someWindow();
    RandomNumbers random (3);
    const Eigen::MatrixXd voltages = random.normal (window * actuators).reshaped (window, actuators);
    const Eigen::MatrixXd multipliers = random.normal (length * points).reshaped (length, points);
    CHECK (responses.motion (voltages).cwiseProduct (multipliers).sum()
           == Approx (responses.pulls (multipliers).cwiseProduct (voltages).sum()).epsilon (1e-12));
}

TEST_CASE ("Pulls and preconditioner of a point that moves are those of its dense matrix", "[tracks]")
{
    auto responses = movingWindow();
    REQUIRE (responses.points() == 1);
    RandomNumbers random (3);
    const Eigen::MatrixXd voltages = random.normal (window * actuators).reshaped (window, actuators);
    const Eigen::MatrixXd multipliers = random.normal (length), others = random.normal (length);
    CHECK (responses.motion (voltages).cwiseProduct (multipliers).sum()
           == Approx (responses.pulls (multipliers).cwiseProduct (voltages).sum()).epsilon (1e-12));
    CHECK (responses.precondition (others).cwiseProduct (multipliers).sum()
           == Approx (responses.precondition (multipliers).cwiseProduct (others).sum()).epsilon (1e-12));

    const Eigen::MatrixXd wanted = someWanted().col (0);
    const auto solution = solveTracks (responses, wanted);
    const auto dense = denseResponses (responses);
    Eigen::MatrixXd normal = dense.transpose() * dense;
    normal.diagonal().array() += compliance;
    const Eigen::VectorXd expected = normal.ldlt().solve (dense.transpose() * wanted);
    CHECK ((solution.voltages.reshaped() - expected).norm() < 1e-2 * expected.norm());
    CHECK (solution.error == Approx ((dense * expected - wanted).norm() / wanted.norm()).margin (2e-4));
}

TEST_CASE ("Without limits the voltages are those of the dense least squares", "[tracks]")
{
    auto responses = someWindow();
    const auto wanted = someWanted();
    const auto solution = solveTracks (responses, wanted);
    const auto dense = denseResponses (responses);
    Eigen::MatrixXd normal = dense.transpose() * dense;
    normal.diagonal().array() += compliance;
    const Eigen::VectorXd expected = normal.ldlt().solve (dense.transpose() * wanted.reshaped());

    // The gradients end at 1e-4 of the wanted motion, which the lowest curvature, the compliance, may enlarge.
    CHECK ((solution.voltages.reshaped() - expected).norm() < 1e-2 * expected.norm());
    const auto error = (dense * expected - wanted.reshaped()).norm() / wanted.norm();
    CHECK (solution.error == Approx (error).margin (2e-4));
    CHECK (solution.bound <= solution.objective * (1 + 1e-9));
    CHECK (solution.bound > 0.999 * solution.objective);
}

TEST_CASE ("Within limits the voltages are those of projected gradients on the dense matrix", "[tracks]")
{
    auto responses = someWindow();
    const auto wanted = someWanted();
    const auto unlimited = solveTracks (responses, wanted);
    const auto peak = unlimited.voltages.cwiseAbs().maxCoeff();
    const Eigen::VectorXd limits = Eigen::Vector4d (0.5, 0.6, 0.7, 0.4) * peak;
    const auto solution = solveLimitedTracks (responses, wanted, limits, unlimited.multipliers);
    CHECK (((solution.voltages.cwiseAbs().colwise().maxCoeff().transpose() - limits).array() <= 0).all());
    CHECK (solution.bound <= solution.objective * (1 + 1e-9));
    CHECK (solution.bound > 0.999 * solution.objective);

    const auto dense = denseResponses (responses);
    Eigen::MatrixXd normal = dense.transpose() * dense;
    normal.diagonal().array() += compliance;
    const Eigen::VectorXd right = dense.transpose() * wanted.reshaped();
    const auto step = 1 / normal.eigenvalues().real().maxCoeff();
    const Eigen::VectorXd bounds = limits.transpose().replicate (window, 1).reshaped();
    Eigen::VectorXd u = Eigen::VectorXd::Zero (right.size()), ahead = u;
    double momentum = 1;

    for (int i = 0; i < 20000; ++i) // Beck and Teboulle's accelerated gradients
    {
        const Eigen::VectorXd next = (ahead - step * (normal * ahead - right)).cwiseMin (bounds).cwiseMax (-bounds);
        const auto more = (1 + std::sqrt (1 + 4 * momentum * momentum)) / 2;
        ahead = next + (momentum - 1) / more * (next - u);
        u = next;
        momentum = more;
    }

    const auto objective = u.squaredNorm() / 2 + (dense * u - wanted.reshaped()).squaredNorm() / (2 * compliance);
    CHECK (solution.objective == Approx (objective).epsilon (1e-3));
}

TEST_CASE ("No voltages within a smaller limit reach the error of a limited solution", "[tracks]")
{
    auto responses = someWindow();
    const auto wanted = someWanted();
    const auto unlimited = solveTracks (responses, wanted);
    const Eigen::VectorXd limits =
        Eigen::VectorXd::Constant (actuators, 0.5 * unlimited.voltages.cwiseAbs().maxCoeff());
    const auto solution = solveLimitedTracks (responses, wanted, limits, unlimited.multipliers);
    const auto bound = peakBound (responses, wanted, limits, solution.multipliers, solution.error);
    CHECK (bound > 0.5);
    CHECK (bound <= 1 + 1e-9);

    // With limits below the bound every solution has a larger error.
    const auto less = solveLimitedTracks (responses, wanted, 0.95 * bound * limits, solution.multipliers);
    CHECK (less.error > solution.error);
}
