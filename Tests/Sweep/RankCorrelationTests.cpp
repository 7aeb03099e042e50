#include <antinode_sweep/SweepTable.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;

TEST_CASE ("Rank correlation is 1 for what rises together, however bent, and counts ties half", "[sweep]")
{
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced (20, 0, 5);
    CHECK (rankCorrelation (x, x.array().exp()) == Approx (1));
    CHECK (rankCorrelation (x, -x.array().cube()) == Approx (-1));
    CHECK (rankCorrelation (x, Eigen::VectorXd::Ones (20)) == 0);
    // Kendall, Rank correlation methods: ranks 1 2.5 2.5 4 against 1 2 3 4: sqrt (0.9).
    CHECK (rankCorrelation (Eigen::Vector4d (1, 2, 2, 3), Eigen::Vector4d (1, 2, 3, 4))
           == Approx (4.5 / std::sqrt (4.5 * 5)));
}
