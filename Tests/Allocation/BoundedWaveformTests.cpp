#include <antinode_allocation/BoundedWaveform.h>
#include <antinode_allocation/FreeGrams.h>

#include <catch2/catch.hpp>

#include <random>
#include <utility>
#include <vector>

using namespace antinode;

namespace
{
Eigen::MatrixXd randomMatrix (Eigen::Index rows, Eigen::Index columns, unsigned seed)
{
    std::mt19937 random (seed);
    return Eigen::MatrixXd::NullaryExpr (rows, columns,
                                         [&] { return static_cast<double> (random()) / 2147483647.5 - 1; });
}

/** Hard rows, and so many soft ones. */
BoundedWaveformProblem randomProblem (Eigen::Index hard, Eigen::Index soft, unsigned seed)
{
    BoundedWaveformProblem problem;
    problem.weights = randomMatrix (hard + soft, 300, seed);
    problem.participation = randomMatrix (hard + soft, 4, seed + 1);
    problem.wanted = randomMatrix (hard + soft, 1, seed + 2);
    problem.wanted.tail (soft).setZero();
    problem.compliance = Eigen::VectorXd::Zero (hard + soft);
    problem.compliance.tail (soft).setConstant (10);
    problem.limits = Eigen::VectorXd::Constant (4, 5);
    return problem;
}
} // namespace

TEST_CASE ("Samples near their bound: so many times the least peak that an interior point finds, rows as exact",
           "[allocation][nearBound]")
{
    for (unsigned seed = 0; seed < 20; ++seed)
        for (const auto nearness : { 1.03, 1.25, 2.0 })
        {
            CAPTURE (seed, nearness);
            auto problem = randomProblem (6, 0, 7 * seed);
            const auto bracket = minimumWaveformPeak (problem, 1e-3);
            problem.nearness = nearness;
            const auto solution = solveBoundedWaveform (problem);
            const auto peak = solution.samples.cwiseAbs().maxCoeff() / 5;
            CHECK (solution.isMet);
            CHECK (peak <= nearness * bracket.upper);
            CHECK (peak >= bracket.lower);
            CHECK (solution.peakBound <= bracket.upper);
            CHECK (peak <= nearness * solution.peakBound * (1 + 1e-12));
            CHECK (solution.limitShare == Approx (peak));
        }
}

TEST_CASE ("Soft rows do not keep samples from coming near the bound of the hard ones", "[allocation][nearBound]")
{
    for (unsigned seed = 0; seed < 10; ++seed)
    {
        auto problem = randomProblem (5, 30, seed);
        problem.nearness = 1.25;
        const auto solution = solveBoundedWaveform (problem);
        auto hard = randomProblem (5, 30, seed);
        hard.weights.conservativeResize (5, Eigen::NoChange);
        hard.participation.conservativeResize (5, Eigen::NoChange);
        hard.wanted.conservativeResize (5);
        hard.compliance.conservativeResize (5);
        CAPTURE (seed);
        CHECK (solution.isMet);
        CHECK (solution.samples.cwiseAbs().maxCoeff() / 5 <= 1.25 * minimumWaveformPeak (hard, 1e-3).upper);
    }
}

TEST_CASE ("Limits below what is near the bound stay as they are, and too low ones are still refused",
           "[allocation][nearBound]")
{
    auto problem = randomProblem (6, 0, 3);
    const auto least = 5 * minimumWaveformPeak (problem, 1e-3).upper;
    problem.nearness = 2;
    problem.limits.setConstant (1.1 * least);
    const auto kept = solveBoundedWaveform (problem);
    CHECK (kept.isMet);
    CHECK (kept.limitShare == 1);
    CHECK (kept.samples.cwiseAbs().maxCoeff() <= 1.1 * least * (1 + 1e-12));
    problem.limits.setConstant (0.9 * least);
    const auto refused = solveBoundedWaveform (problem);
    CHECK_FALSE (refused.isMet);
    CHECK (refused.peakBound > 1);
}

TEST_CASE ("Samples keep limits of their own, and multipliers nearby lead to the same ones", "[allocation][nearBound]")
{
    for (unsigned seed = 0; seed < 10; ++seed)
    {
        CAPTURE (seed);
        auto problem = randomProblem (6, 10, 5 * seed);
        problem.limits.setConstant (3 * minimumWaveformPeak (randomProblem (6, 0, 5 * seed), 1e-2).upper * 5);
        problem.shares = 0.75 + 0.25 * randomMatrix (4, 300, seed + 90).array();
        const auto solution = solveBoundedWaveform (problem);
        REQUIRE (solution.isMet);
        const Eigen::MatrixXd allowed = problem.limits.asDiagonal() * problem.shares;
        CHECK ((solution.samples.cwiseAbs().array() <= allowed.array() * (1 + 1e-12)).all());
        // The least there is: weak duality holds with limits of single samples too.
        CHECK (solution.objective == Approx (solution.bound).epsilon (1e-9));

        problem.start = { 0.8 * solution.multipliers.rows, {} };
        const auto again = solveBoundedWaveform (problem);
        CHECK ((again.samples - solution.samples).cwiseAbs().maxCoeff()
               < 1e-8 * solution.samples.cwiseAbs().maxCoeff());
    }
}

namespace
{
/** A problem of which half of the rows and ceramics have a spread. */
BoundedWaveformProblem spreadProblem (unsigned seed, double share)
{
    auto problem = randomProblem (5, 8, seed);
    auto hard = problem;
    hard.weights.conservativeResize (5, Eigen::NoChange);
    hard.participation.conservativeResize (5, Eigen::NoChange);
    hard.wanted.conservativeResize (5);
    hard.compliance.conservativeResize (5);
    problem.limits *= share * minimumWaveformPeak (hard, 1e-2).upper;
    problem.spread = (3 * randomMatrix (13, 4, seed + 50)).cwiseMax (0.0);
    return problem;
}

/** The same with a soft row for each of its spreads. */
BoundedWaveformProblem withRowsForSpread (BoundedWaveformProblem problem)
{
    const auto spread = std::exchange (problem.spread, {});
    const auto append = [] (auto& to, const auto& row)
    {
        to.conservativeResize (to.rows() + 1, to.cols());
        to.bottomRows (1) = row;
    };

    for (Eigen::Index k = 0; k < spread.rows(); ++k)
        for (Eigen::Index i = 0; i < spread.cols(); ++i)
            if (spread (k, i) > 0)
            {
                append (problem.weights, Eigen::MatrixXd (spread (k, i) * problem.weights.row (k)));
                append (problem.participation, Eigen::MatrixXd (Eigen::RowVectorXd::Unit (spread.cols(), i)));
                append (problem.wanted, Eigen::MatrixXd::Zero (1, 1));
                append (problem.compliance, Eigen::MatrixXd::Ones (1, 1));
            }

    return problem;
}
} // namespace

TEST_CASE ("What each ceramic's part of a row costs is a soft row of that ceramic alone", "[allocation][spread]")
{
    for (unsigned seed = 0; seed < 10; ++seed)
        for (const auto share : { 1.2, 2.0, 20.0 })
        {
            CAPTURE (seed, share);
            const auto problem = spreadProblem (20 * seed, share);
            const auto solution = solveBoundedWaveform (problem),
                       expected = solveBoundedWaveform (withRowsForSpread (problem));
            REQUIRE (solution.isMet);
            CHECK ((solution.samples - expected.samples).cwiseAbs().maxCoeff()
                   < 1e-8 * expected.samples.cwiseAbs().maxCoeff());
            CHECK (solution.objective == Approx (expected.objective).epsilon (1e-9));
            CHECK (solution.objective == Approx (solution.bound).epsilon (1e-9));
            CHECK (solution.softCost == Approx (expected.softCost).epsilon (1e-7));
        }
}

TEST_CASE ("Of samples that cost as little in soft rows, multipliers prove a least peak that none goes below",
           "[allocation][spread]")
{
    for (unsigned seed = 0; seed < 10; ++seed)
    {
        std::vector<BoundedWaveformProblem> problems;
        std::vector<BoundedWaveform> solutions;

        for (const auto share : { 1.1, 1.3, 1.6, 2.5 })
        {
            problems.push_back (spreadProblem (20 * seed, share));
            solutions.push_back (solveBoundedWaveform (problems.back()));
        }

        const auto& all = problems.back();

        for (const auto& proof : solutions)
            for (const auto& played : solutions)
            {
                CAPTURE (seed);
                const auto least = provenPeak (all, proof.multipliers, played.softCost);
                CHECK (least <= played.samples.cwiseAbs().maxCoeff() / all.limits[0] * (1 + 1e-12));
            }

        // Its own multipliers are near where limits bind.
        const auto& tight = solutions.front();
        CHECK (provenPeak (problems.front(), tight.multipliers, tight.softCost) > 0.8);
    }
}

TEST_CASE ("A solver that is asked again for other limits finds what a new one finds", "[allocation][nearBound]")
{
    auto problem = spreadProblem (7, 3);
    BoundedWaveformSolver solver (problem);
    const auto first = solver.solve();
    const Eigen::MatrixXd shares = 0.75 + 0.25 * randomMatrix (4, 300, 90).array();
    const auto again = solver.solveWithin (0.8, shares, first.multipliers);
    problem.limits *= 0.8;
    problem.shares = shares;
    const auto anew = solveBoundedWaveform (problem);
    REQUIRE (again.isMet);
    CHECK ((again.samples - anew.samples).cwiseAbs().maxCoeff() < 1e-8 * anew.samples.cwiseAbs().maxCoeff());
}

TEST_CASE ("Gram matrices of free samples are the same from step to step as anew", "[allocation]")
{
    const auto weights = randomMatrix (9, 200, 1);
    const Eigen::MatrixXd whole = weights * weights.transpose();
    const Eigen::MatrixXd caps = Eigen::MatrixXd::Constant (3, 200, 0.5);
    FreeGrams grams (weights, whole, 3);
    auto pulls = randomMatrix (3, 200, 2);

    for (unsigned step = 0; step < 6; ++step)
    {
        pulls += (step % 2 == 0 ? 0.05 : 0.8) * randomMatrix (3, 200, 10 + step);
        grams.follow (pulls, caps);

        for (Eigen::Index i = 0; i < 3; ++i)
        {
            const Eigen::VectorXd isFree = (pulls.row (i).array().abs() < 0.5).cast<double>();
            const Eigen::MatrixXd expected = weights * isFree.asDiagonal() * weights.transpose();
            const Eigen::MatrixXd difference = (grams.of (i) - expected).triangularView<Eigen::Lower>();
            CHECK (difference.cwiseAbs().maxCoeff() < 1e-12 * whole.cwiseAbs().maxCoeff());
        }
    }
}

TEST_CASE ("The curvature is the same whether few or many samples are at their limit", "[allocation]")
{
    const auto weights = randomMatrix (9, 200, 1), participation = randomMatrix (9, 3, 3);
    const Eigen::MatrixXd whole = weights * weights.transpose();
    const Eigen::MatrixXd caps = Eigen::Vector3d (0.9, 0.5, 0.95) * Eigen::RowVectorXd::Ones (200);
    FreeGrams grams (weights, whole, 3, 20);
    auto pulls = randomMatrix (3, 200, 2);

    for (unsigned step = 0; step < 6; ++step)
    {
        pulls *= step % 2 == 0 ? 0.9 : 1.2;
        grams.follow (pulls, caps);
        Eigen::MatrixXd sum = Eigen::MatrixXd::Identity (9, 9), expected = sum;
        grams.addWeighted (sum, participation);

        for (Eigen::Index i = 0; i < 3; ++i)
        {
            const Eigen::VectorXd isFree = (pulls.row (i).array().abs() < caps (i, 0)).cast<double>();
            const Eigen::MatrixXd seen = participation.col (i).asDiagonal() * weights;
            expected += seen * isFree.asDiagonal() * seen.transpose();
        }

        const Eigen::MatrixXd difference = (sum - expected).triangularView<Eigen::Lower>();
        CHECK (difference.cwiseAbs().maxCoeff() < 1e-12 * expected.cwiseAbs().maxCoeff());
    }
}
