#include "Support/SineBeam.h"

#include <antinode_learning/LearningEquations.h>
#include <antinode_learning/LearningProblem.h>
#include <antinode_learning/ParameterEffects.h>
#include <antinode_learning/PlayedVoltages.h>
#include <antinode_numerics/Statistics.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace antinode;

namespace
{
constexpr double recordedRate = 24000; // Hz
constexpr Eigen::Index drivenFor = 60, recordedFor = 900;

/** Noise on two ceramics, then silence; two sensors, of which one is itself uncertain, hear something of the kind. */
PlayedRecording noisePlayed (const ModalModel& model)
{
    RandomNumbers random (5);
    PlayedRecording recording {
        recordedRate, Eigen::MatrixXd::Zero (model.actuators(), recordedFor), {}, {}, 4.3e-4, 0
    };

    for (Eigen::Index i = 0; i < model.actuators(); ++i)
        recording.voltages.row (i).head (drivenFor) = 20 * random.normal (drivenFor).transpose();

    auto other = model;
    other.angularFrequencies *= 1.002;
    const auto velocities = modeVelocities (other, { recording.voltages, recordedRate }, recordedFor);
    recording.signals = Eigen::MatrixXd::Zero (2, recordedFor);
    recording.signals.row (0).tail (recordedFor - 10) =
        (velocities * shapesAt (model, 0.03, 0).transpose()).head (recordedFor - 10).transpose();
    recording.signals.row (1).tail (recordedFor - 10) =
        (velocities * shapesAt (model, -0.05, 0).transpose()).head (recordedFor - 10).transpose();
    recording.noise = 0.01 * recording.signals.rowwise().norm() / std::sqrt (static_cast<double> (recordedFor));
    recording.cubes = cubedVoltages (recording.voltages);
    return recording;
}
} // namespace

TEST_CASE ("The right sides of a recording's equations are the slopes of its misfit, by delay as well", "[learning]")
{
    const auto model = test::sineBeam (5, 3);
    const auto recording = noisePlayed (model);
    const std::vector<PlayedRecording> recordings { recording };
    const std::vector<Sensor> sensors { { shapesAt (model, 0.03, 0) },
                                        { shapesAt (model, -0.05, 0), 0.05 * shapesAt (model, -0.05, 0).cwiseAbs() } };
    auto deviations = sameSpread (model.modes(), 0.005, 0.1, 0.05);
    deviations.drift = 0.002;
    deviations.delay = 1e-5;
    const auto prior = makePrior (model, sensors, deviations, recordings);
    const auto parameters = heardParameters (prior);
    RandomNumbers random (8);
    const Eigen::VectorXd values = 0.3 * random.normal (parameters.size());
    constexpr Eigen::Index samples = 500;
    const auto misfit = [&] (const Eigen::VectorXd& at)
    { return recordingMisfit (prior, stateAt (prior, parameters, at), 0, samples).residual; };
    const auto equations = recordingEquations (prior, parameters, stateAt (prior, parameters, values), 0, samples);

    for (const auto kind :
         { ParameterKind::frequency, ParameterKind::damping, ParameterKind::participation, ParameterKind::sensor })
        REQUIRE (std::any_of (parameters.modal.begin(), parameters.modal.end(),
                              [kind] (const auto& parameter) { return parameter.kind == kind; }));

    REQUIRE (std::ssize (parameters.distorting) == model.actuators());

    CHECK (equations.misfit.residual == Approx (misfit (values)));
    CHECK (equations.misfit.samples == 2 * samples);

    for (Eigen::Index p = 0; p < parameters.size(); ++p)
    {
        constexpr double step = 1e-4;
        const Eigen::VectorXd change = step * Eigen::VectorXd::Unit (parameters.size(), p);
        const auto slope = (misfit (values + change) - misfit (values - change)) / (2 * step);
        INFO ("parameter " << p << " of " << parameters.size());
        CHECK (-2 * equations.right[p] == Approx (slope).epsilon (1e-4).margin (1e-6 * equations.right.norm()));
    }
}

TEST_CASE ("The matrix of a recording's equations is the curvature of its misfit where all is explained", "[learning]")
{
    const auto model = test::sineBeam (5, 3);
    auto recording = noisePlayed (model);
    recording.delay = 0;
    const std::vector<Sensor> sensors { { shapesAt (model, 0.03, 0) },
                                        { shapesAt (model, -0.05, 0), 0.05 * shapesAt (model, -0.05, 0).cwiseAbs() } };
    auto deviations = sameSpread (model.modes(), 0.005, 0.1, 0.05);
    deviations.drift = 0.002;
    const auto velocities = modeVelocities (model, { recording.voltages, recordedRate }, recordedFor);
    recording.signals.row (0) = (velocities * sensors[0].shapes.transpose()).transpose();
    recording.signals.row (1) = (velocities * sensors[1].shapes.transpose()).transpose();
    const std::vector<PlayedRecording> recordings { recording };
    const auto prior = makePrior (model, sensors, deviations, recordings);
    const auto parameters = heardParameters (prior);
    constexpr Eigen::Index samples = 500;
    const Eigen::VectorXd none = Eigen::VectorXd::Zero (parameters.size());
    const auto equations = recordingEquations (prior, parameters, stateAt (prior, parameters, none), 0, samples);
    const auto misfit = [&] (Eigen::Index p, Eigen::Index q, double onP, double onQ)
    {
        Eigen::VectorXd at = none;
        at[p] += onP;
        at[q] += onQ;
        return recordingMisfit (prior, stateAt (prior, parameters, at), 0, samples).residual;
    };
    REQUIRE (std::ssize (parameters.distorting) == model.actuators());
    constexpr double step = 1e-3;

    for (Eigen::Index i = 0; i < model.actuators(); ++i)
        for (Eigen::Index q = 0; q <= parameters.distortion (i); ++q)
        {
            const auto p = parameters.distortion (i);
            const auto curvature = (misfit (p, q, step, step) - misfit (p, q, step, -step) - misfit (p, q, -step, step)
                                    + misfit (p, q, -step, -step))
                                   / (4 * step * step);
            const auto scale = std::sqrt (equations.matrix (p, p) * equations.matrix (q, q));
            INFO ("parameters " << p << " and " << q << " of " << parameters.size());
            CHECK (2 * equations.matrix (p, q) == Approx (curvature).epsilon (1e-3).margin (2e-3 * scale));
        }
}

TEST_CASE ("Parameters that are clearly heard are those of which recordings tell most", "[learning]")
{
    const auto model = test::sineBeam (5, 3);
    const std::vector<PlayedRecording> recordings { noisePlayed (model) };
    const std::vector<Sensor> sensors { { shapesAt (model, 0.03, 0) },
                                        { shapesAt (model, -0.05, 0), 0.05 * shapesAt (model, -0.05, 0).cwiseAbs() } };
    const auto deviations = sameSpread (model.modes(), 1e-4, 0.01, 1e-3);
    const auto prior = makePrior (model, sensors, deviations, recordings);
    const LearningProblem problem (prior);
    const auto& all = problem.all();
    const auto& clear = problem.clearlyHeard();

    REQUIRE (clear.parameters.modal.size() > 1);
    REQUIRE (clear.parameters.modal.size() < all.parameters.modal.size());
    // The drift and the delay are always among them.
    CHECK (std::ssize (clear.places) == clear.parameters.size());
    CHECK (clear.places.back() == all.parameters.delay (0));

    for (std::size_t p = 0, next = 0; p < all.parameters.modal.size(); ++p)
    {
        const auto isClear = clear.places[next] == static_cast<Eigen::Index> (p);
        CHECK ((all.parameters.modal[p].information > 10) == isClear);
        next += isClear ? 1 : 0;
    }
}

TEST_CASE ("How far a frequency is off counts where its mode is heard well", "[learning]")
{
    const auto model = test::sineBeam (10, 3); // to 11.5 kHz; of 24 kHz, up to 9.6 are heard well
    const std::vector<PlayedRecording> recordings { noisePlayed (model) };
    const std::vector<Sensor> sensors { { shapesAt (model, 0.03, 0) },
                                        { shapesAt (model, -0.05, 0), 0.05 * shapesAt (model, -0.05, 0).cwiseAbs() } };
    const auto deviations = sameSpread (model.modes(), 0.005, 0.1, 0.05);
    const auto prior = makePrior (model, sensors, deviations, recordings);
    const LearningProblem problem (prior);
    int frequencies = 0;

    for (Eigen::Index p = 0; p < problem.all().parameters.drift(); ++p)
    {
        const auto& parameter = problem.all().parameters.modal[static_cast<std::size_t> (p)];
        const auto counts = parameter.kind == ParameterKind::frequency && parameter.mode < 9;
        const Eigen::VectorXd values = -7 * Eigen::VectorXd::Unit (problem.all().parameters.size(), p);
        CHECK (problem.largestMoveHeardWell (values) == (counts ? 7 : 0));
        frequencies += parameter.kind == ParameterKind::frequency;
    }

    CHECK (frequencies == 10);
}

TEST_CASE ("Only the unknowns that are looked for move, and the records are explained better", "[learning]")
{
    const auto model = test::sineBeam (5, 3);
    auto later = noisePlayed (model);
    later.delay = 4e-4;
    const std::vector<PlayedRecording> recordings { noisePlayed (model), later };
    const std::vector<Sensor> sensors { { shapesAt (model, 0.03, 0) },
                                        { shapesAt (model, -0.05, 0), 0.05 * shapesAt (model, -0.05, 0).cwiseAbs() } };
    const auto deviations = sameSpread (model.modes(), 1e-4, 0.01, 1e-3);
    const auto prior = makePrior (model, sensors, deviations, recordings);
    const LearningProblem problem (prior);
    RandomNumbers random (3);
    const Eigen::VectorXd from = 0.2 * random.normal (problem.all().parameters.size());
    const auto objective = [&] (const Eigen::VectorXd& values)
    {
        const auto state = problem.state (values);
        return recordingMisfit (prior, state, 0, recordedFor / 2).residual
               + recordingMisfit (prior, state, 1, recordedFor / 2).residual + values.squaredNorm();
    };
    const auto solution = problem.solve (problem.clearlyHeard(), from, recordedFor / 2 / recordedRate, 1e-5, 100);
    const auto& places = problem.clearlyHeard().places;
    REQUIRE (std::ssize (places) < from.size());
    CHECK (objective (solution.values) < 0.5 * objective (from));

    for (Eigen::Index p = 0; p < from.size(); ++p)
        if (! std::binary_search (places.begin(), places.end(), p))
            CHECK (solution.values[p] == from[p]);

    // Each recording has its own delay, which is found: both were made with the same one, 10 samples.
    CHECK (problem.state (solution.values).delays[1]
           == Approx (problem.state (solution.values).delays[0]).margin (3e-6));
}
