#include "LearningBench.h"

#include <antinode_learning/LearningProblem.h>

#include <Eigen/Cholesky>
#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;
using namespace antinode::test;

TEST_CASE ("Where bounds stop some values, the others still go on to where nothing is gained", "[learning]")
{
    constexpr double furthest = 0.5, time = 0.12; // deviations, s
    const Bench bench (0.005, 2);
    const auto spread = sameSpread (allModes, 0.005, 0.1, 0.05);
    const std::vector<PlayedRecording> recordings { bench (bench.exactVoltages(), 0) };
    const auto sensors = bench.sensors();
    const auto prior = makePrior (bench.nominal.model, sensors, spread, recordings);
    const LearningProblem problem (prior);
    const auto& parameters = problem.all().parameters;
    const auto values =
        problem.solve (problem.all(), Eigen::VectorXd::Zero (parameters.size()), time, 1e-9, furthest).values;
    auto equations =
        recordingEquations (prior, parameters, problem.state (values), 0, comparableSamples (recordings.front()));
    equations.matrix.diagonal().array() += 1;
    equations.right -= values;
    int held = 0;

    for (Eigen::Index p = 0; p < parameters.size(); ++p)
        if (std::abs (values[p]) >= furthest - 1e-9)
        {
            CHECK (values[p] * equations.right[p] > 0); // It is pushed outwards.
            equations.right[p] = 0;
            equations.matrix.row (p).setZero();
            equations.matrix.col (p).setZero();
            equations.matrix (p, p) = 1;
            ++held;
        }

    REQUIRE (held > 2);
    // What a step of the others would gain in the objective.
    const Eigen::MatrixXd whole = equations.matrix.selfadjointView<Eigen::Lower>();
    CHECK (equations.right.dot (whole.ldlt().solve (equations.right)) < 0.05 * static_cast<double> (parameters.size()));
}
