#include <antinode_numerics/GaussNewton.h>
#include <antinode_numerics/Statistics.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;

TEST_CASE ("Where one unknown is held at its bound, the other one goes to the minimum that is left", "[numerics]")
{
    // x^2 + y^2 + 1.8 x y - 4 x - 3.6 y has its minimum at (2, 0); along a step of 0.5 in x at (3.6 - 1.8 * 0.5) / 2.
    const Eigen::MatrixXd matrix = (Eigen::MatrixXd (2, 2) << 2, 0, 1.8, 2).finished(); // The lower triangle.
    const Eigen::Vector2d right (4, 3.6);
    const auto free = boundedStep (matrix, right, Eigen::Vector2d (-10, -10), Eigen::Vector2d (10, 10));
    CHECK (free.change[0] == Approx (2));
    CHECK (free.change[1] == Approx (0).margin (1e-12));

    const auto held = boundedStep (matrix, right, Eigen::Vector2d (-1.5, -10.25), Eigen::Vector2d (0.5, 9.75));
    CHECK (held.change[0] == Approx (0.5));
    CHECK (held.change[1] == Approx ((3.6 - 1.8 * 0.5) / 2));
    // The one that is held keeps its deviation: its row of the factor is that of the unit matrix.
    const auto factored = factorOfFree (held, matrix);
    CHECK (factored (0, 0) == Approx (1));
    CHECK (factored (1, 0) == Approx (0).margin (1e-12));
}

TEST_CASE ("A step within bounds fulfils the conditions of Karush, Kuhn and Tucker", "[numerics]")
{
    constexpr Eigen::Index count = 40;
    const auto seed = GENERATE (range<std::uint64_t> (1, 6));
    const auto bound = GENERATE (0.1, 0.8); // Most are held; few are.
    CAPTURE (seed, bound);
    RandomNumbers random (seed);
    Eigen::MatrixXd rows (60, count);

    for (Eigen::Index p = 0; p < count; ++p)
        rows.col (p) = random.normal (60);

    const Eigen::MatrixXd matrix = rows.transpose() * rows + Eigen::MatrixXd::Identity (count, count);
    const Eigen::VectorXd right = 60 * random.normal (count), bounds = Eigen::VectorXd::Constant (count, bound);
    const Eigen::VectorXd values = (0.5 * random.normal (count)).cwiseMax (-bounds).cwiseMin (bounds);
    const auto step = boundedStep (matrix, right, -bounds - values, bounds - values);
    const Eigen::VectorXd slope = right - matrix * step.change, next = values + step.change;
    int held = 0;

    for (Eigen::Index p = 0; p < count; ++p)
    {
        CHECK (std::abs (next[p]) <= bounds[p] + 1e-12);

        if (std::abs (next[p]) < bounds[p] - 1e-9)
            CHECK (slope[p] == Approx (0).margin (1e-8 * right.norm()));
        else
            CHECK (next[p] * slope[p] >= 0);

        held += std::abs (next[p]) < bounds[p] - 1e-9 ? 0 : 1;
    }

    CHECK (held > (bound < 0.5 ? count / 2 : 3));
    CHECK (held < (bound < 0.5 ? count : count - 3));
}

TEST_CASE ("The most probable value lies between the data and what was known, or at its bound", "[numerics]")
{
    // 100 (x^2 - 1)^2 + x^2 has its minimum where x^2 = 1 - 1 / 200. The full step from 0.1 leads up.
    const auto sum = [] (const Eigen::VectorXd& x) { return 100 * std::pow (x[0] * x[0] - 1, 2) + x[0] * x[0]; };
    const SumOfSquares squares { [&] (const Eigen::VectorXd& x) -> SumOfSquares::Equations
                                 {
                                     const auto change = 20 * x[0], residual = 10 * (1 - x[0] * x[0]);
                                     return { Eigen::MatrixXd::Constant (1, 1, 1 + change * change),
                                              Eigen::VectorXd::Constant (1, change * residual - x[0]), sum (x) };
                                 },
                                 sum };
    const auto one = [] (double value) { return Eigen::VectorXd::Constant (1, value).eval(); };
    const auto from = GENERATE (0.1, 0.6, 3.0);
    CAPTURE (from);
    GaussNewtonSettings settings { 30, 1e-12, 0, one (10), one (1e9), {} };
    const auto free = smallestSum (squares, one (from), settings);
    CHECK (free.values[0] == Approx (std::sqrt (0.995)).epsilon (1e-6));
    CHECK (free.factored (0, 0) == Approx (std::sqrt (1 + 400 * 0.995)).epsilon (1e-4));
    CHECK (free.sum == Approx (sum (free.values)));

    settings.bounds = one (0.5);
    CHECK (smallestSum (squares, one (0.1), settings).values[0] == Approx (0.5));

    settings = { 30, 1e-12, 0, one (10), one (1e9), [] (int steps, double) { return steps == 1; } };
    CHECK (smallestSum (squares, one (3), settings).values[0] > 1.1);
}
