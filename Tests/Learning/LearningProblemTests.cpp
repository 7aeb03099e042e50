#include "LearningBench.h"

#include <antinode_focus/SpillOver.h>
#include <antinode_learning/LearningProblem.h>
#include <antinode_learning/ModeSpread.h>
#include <antinode_numerics/Statistics.h>

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

TEST_CASE ("Modes that are mixtures of their neighbours are learnt as such, on the whole surface", "[learning]")
{
    // Two modes of one beam 1 % apart whose shapes are turned by 3 degrees: sensors at two places hear it.
    auto known = test::sineBeam (4, 3);
    known.angularFrequencies[1] = 0.99 * known.angularFrequencies[2];
    auto truth = known;
    constexpr double share = 0.05;
    truth.shapes.col (1) += share * known.shapes.col (2);
    truth.shapes.col (2) -= share * known.shapes.col (1);
    truth.participation.row (1) += share * known.participation.row (2);
    truth.participation.row (2) -= share * known.participation.row (1);
    truth.slopes.resize (0, 0);
    known.slopes.resize (0, 0);
    const auto heard = [] (const ModalModel& model, Eigen::Index point) -> Eigen::RowVectorXd
    { return model.shapes.row (point); };
    std::vector<Sensor> sensors, exact;

    for (const auto point : { known.points() / 7, known.points() / 3, 3 * known.points() / 4 })
    {
        const auto shapes = heard (known, point);
        sensors.push_back ({ shapes, Eigen::RowVectorXd::Constant (known.modes(), 0.01 * shapes.norm()) });
        exact.push_back ({ heard (truth, point) });
    }

    constexpr double rate = 48000;
    constexpr Eigen::Index samples = 6000;
    RandomNumbers random (3);
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (known.actuators(), samples);

    for (Eigen::Index i = 0; i < voltages.rows(); ++i)
        voltages.row (i).head (600) = 10 * random.normal (600).transpose();

    const auto velocities = modeVelocities (truth, { voltages, rate }, samples);
    PlayedRecording recording { rate, voltages, Eigen::MatrixXd (3, samples), {}, 0, 0 };

    for (Eigen::Index m = 0; m < 3; ++m)
        recording.signals.row (m) = (velocities * exact[static_cast<std::size_t> (m)].shapes.transpose()).transpose();

    recording.noise = 0.003 * recording.signals.rowwise().norm() / std::sqrt (samples);

    for (Eigen::Index m = 0; m < 3; ++m)
        recording.signals.row (m) += recording.noise[m] * random.normal (samples).transpose();

    auto spread = sameSpread (known.modes(), 0.002, 0.1, 0.01);
    spread.mixing = 0.0015;
    spread.distortion = 0;
    const auto learnt = learnModes (known, sensors, spread, { recording });
    CAPTURE (learnt.mixtures.transpose());
    CHECK (learnt.mixtures[1] == Approx (share).epsilon (0.1));
    CHECK ((learnt.model.shapes - truth.shapes).norm() < 0.2 * (known.shapes - truth.shapes).norm());
    CHECK (learnt.heldBack < 0.5 * learnt.heldBackBefore);
}

TEST_CASE ("What no parameter explains is believed to be noise, and moves none", "[learning]")
{
    // A mode that the model lacks, as loud as a third of all: frequencies stay where they are.
    const auto all = test::sineBeam (5, 3);
    const auto known = firstModes (all, 4);
    constexpr double rate = 48000;
    constexpr Eigen::Index samples = 6000;
    RandomNumbers random (4);
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (all.actuators(), samples);

    for (Eigen::Index i = 0; i < voltages.rows(); ++i)
        voltages.row (i).head (600) = 10 * random.normal (600).transpose();

    const Eigen::RowVectorXd shapes = all.shapes.row (all.points() / 3);
    PlayedRecording recording {
        rate, voltages, (modeVelocities (all, { voltages, rate }, samples) * shapes.transpose()).transpose(), {}, 0, 0
    };
    recording.noise = 0.001 * recording.signals.rowwise().norm() / std::sqrt (samples);
    auto spread = sameSpread (known.modes(), 0.002, 0.1, 0.05);
    spread.distortion = 0;
    const auto learnt = learnModes (known, { { shapes.head (4) } }, spread, { recording });
    const Eigen::ArrayXd off = (learnt.model.angularFrequencies.array() / known.angularFrequencies.array()).log();
    CAPTURE (off.transpose(), learnt.residual);
    CHECK (learnt.residual > 3); // of the stated noise
    CHECK (off.abs().maxCoeff() < 5e-4);
    CHECK (learnt.frequencyDeviations.head (3).minCoeff() > 1e-6);
}

TEST_CASE ("A sensor beside its place, with a scale of its own, is learnt as such", "[learning]")
{
    auto known = test::sineBeam (5, 3);
    known.origin.source = ModeSource::drawn;
    constexpr double rate = 48000, beside = 0.002;
    constexpr Eigen::Index samples = 6000;
    RandomNumbers random (5);
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (known.actuators(), samples);

    for (Eigen::Index i = 0; i < voltages.rows(); ++i)
        voltages.row (i).head (600) = 10 * random.normal (600).transpose();

    const auto velocities = modeVelocities (known, { voltages, rate }, samples);
    std::vector<Sensor> sensors;
    Eigen::MatrixXd all (3, known.modes());
    PlayedRecording recording { rate, voltages, Eigen::MatrixXd (3, samples), {}, 0, 0 };

    for (const auto place : { -0.031, 0.013, 0.043 })
    {
        const auto m = std::ssize (sensors);
        const Eigen::RowVectorXd heard =
            m < 2 ? shapesAt (known, place, 0) : Eigen::RowVectorXd (1.005 * shapesAt (known, place + beside, 0));
        recording.signals.row (m) = (velocities * heard.transpose()).transpose();
        sensors.push_back (sensorAt (known, place, 0, beside));
        all.row (m) = heard;
    }

    recording.noise = 0.003 * recording.signals.rowwise().norm() / std::sqrt (samples);
    auto spread = usualDeviations (known);
    spread.distortion = 0;
    const auto learnt = learnModes (known, sensors, spread, { recording });
    CHECK ((learnt.model.participation - known.participation).norm() < 0.01 * known.participation.norm());
    CHECK ((learnt.sensors[2].shapes - all.row (2)).norm() < 0.2 * (sensors[2].shapes - all.row (2)).norm());
}
