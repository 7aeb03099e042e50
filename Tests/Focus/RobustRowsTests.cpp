#include "Support/SineBeam.h"

#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Detuning.h>
#include <antinode_focus/ModeDrives.h>
#include <antinode_focus/Prediction.h>
#include <antinode_focus/RobustRows.h>
#include <antinode_focus/StateRows.h>
#include <antinode_focus/Tolerance.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace antinode;

namespace
{
constexpr double focusTime = 0.025;

FocusDescription sincFocus (double limit)
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, 0.02, 0, 0.025, 0.04, 1 } };
    focus.focusTime = focusTime;
    focus.modes.count = 8;
    focus.allocation.voltageLimit = limit;
    return focus;
}

FocusDescription robustFocus (double limit, const DetuningSpread& spread)
{
    auto focus = sincFocus (limit);
    focus.allocation.robust = Robustness { spread };
    return focus;
}

/** A small problem with rows for the focus of modes 2, 3 and 5, and all that they stand for. */
struct Instance
{
    ModalModel model = test::sineBeam (7, 4);
    RowOrigin origin { { 1, 2, 4 }, { 0, 3, 5, 6 }, {}, focusTime, {} };
    AllocationProblem problem;

    Instance()
    {
        for (const auto& drive : driveModes (model, origin.controlled, focusTime, {}))
            origin.drives.push_back (drive.oscillations);

        const auto velocities = [&] (const std::vector<int>& modes)
        { return rowResponses (model, rowsAt (focusTime, modes, ModalQuantity::velocity), origin.drives, {}); };
        problem.waveforms = Eigen::MatrixXd::Random (3, 400);
        problem.participation = model.participation (origin.controlled, Eigen::all);
        problem.rows = velocities (origin.controlled);
        problem.wanted = Eigen::Vector3d (0.01, -0.02, 0.005);
        problem.guardParticipation = model.participation (origin.guards, Eigen::all);
        problem.guardRows = velocities (origin.guards);
        problem.guardWeight = 100;
        problem.voltageLimits = Eigen::VectorXd::Constant (4, 1e6);
    }
};

double squaredValues (const AllocationProblem& problem, const Eigen::MatrixXd& matrix, Eigen::Index first)
{
    const Eigen::VectorXd values =
        (problem.guardRows * matrix.transpose()).cwiseProduct (problem.guardParticipation).rowwise().sum();
    return values.tail (values.size() - first).squaredNorm();
}
} // namespace

TEST_CASE ("Robust rows square up to the expected squared error of devices drawn", "[robust]")
{
    // Any matrix that meets the hard rows. 4000 draws know the mean square to 3 % or so; a spread of frequencies of
    // 0.05 % is small enough for the quadrature, whose error is of sixth order.
    const Instance instance;
    const DetuningSpread spread { 0.0005, 0.1, 0.05, 0 };
    const auto problem = withRobustRows (instance.problem, instance.model, instance.origin, { spread, 1e9 });
    const auto matrix = minimumNormAllocation (instance.problem);
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero (instance.model.modes());
    wanted (instance.origin.controlled) = instance.problem.wanted;
    std::vector<int> modes { 0, 1, 2, 3, 4, 5, 6 };
    double sum = 0;
    constexpr int draws = 4000;

    for (int draw = 0; draw < draws; ++draw)
    {
        const auto device = detuned (instance.model, spread, static_cast<std::uint64_t> (draw));
        const auto responses =
            rowResponses (device, rowsAt (focusTime, modes, ModalQuantity::velocity), instance.origin.drives, {});
        sum += ((responses * matrix.transpose()).cwiseProduct (device.participation).rowwise().sum() - wanted)
                   .squaredNorm();
    }

    CHECK (squaredValues (problem, matrix, instance.problem.guardRows.rows()) == Approx (sum / draws).epsilon (0.08));
}

TEST_CASE ("Robust rows keep the weight of the guards that are there", "[robust]")
{
    const Instance instance;
    const auto problem = withRobustRows (instance.problem, instance.model, instance.origin, { usualSpread, 1000 });
    const auto guards = instance.problem.guardRows.rows();
    CHECK (problem.guardWeight == 1000);
    CHECK ((problem.guardRows.topRows (guards) * std::sqrt (10.0)).isApprox (instance.problem.guardRows, 1e-14));
    CHECK (problem.guardRows.rows() > guards);
    CHECK (problem.rows == instance.problem.rows);
}

TEST_CASE ("Nothing is added where nothing spreads", "[robust]")
{
    const Instance instance;
    const auto problem =
        withRobustRows (instance.problem, instance.model, instance.origin, { DetuningSpread {}, 1000 });

    // What guards do on the device as it is known is an error too: they may be there once more, but no controlled mode
    // is.
    const auto matrix = minimumNormAllocation (instance.problem);
    const auto guards = instance.problem.guardRows.rows();
    const Eigen::VectorXd known = (instance.problem.guardRows * matrix.transpose())
                                      .cwiseProduct (instance.problem.guardParticipation)
                                      .rowwise()
                                      .sum();
    CHECK (squaredValues (problem, matrix, guards) <= 1.0001 * known.squaredNorm());
}

TEST_CASE ("A robust design is exact on the device as it is known and keeps the limit", "[robust]")
{
    const auto model = test::sineBeam (20, 8);
    const DetuningSpread spread { 0.003, 0.1, 0.05, 0 };
    const auto free = designFocus (model, robustFocus (150, spread), {}, DesignExtent::playable);
    const auto limit = 0.9 * peakVoltage (free);
    const auto design = designFocus (model, robustFocus (limit, spread), {}, DesignExtent::playable);
    const auto reached = modalVelocities (model, predictStates (model, design.program, focusTime));

    for (const auto mode : design.controlledModes)
        CHECK (reached[mode]
               == Approx (design.target.modalVelocities[mode]).margin (1e-9 * reached.cwiseAbs().maxCoeff()));

    CHECK (design.certificate.status == AllocationStatus::optimal);
    CHECK (peakVoltage (design) <= limit * (1 + 1e-9));
}

TEST_CASE ("A robust design has less field error on other devices at the same limit", "[robust]")
{
    // On devices that the design has not seen. The ratios are those measured, 0.4 and 0.3, with room.
    const auto model = test::sineBeam (20, 8);
    const DetuningSpread spread { 0.003, 0.1, 0.05, 0 };
    const auto evaluate = [&] (const FocusDescription& focus)
    {
        return evaluateTolerance (model, designFocus (model, focus, {}, DesignExtent::playable), { spread, 100, 1 },
                                  [] (double) {});
    };
    const auto nominal = evaluate (sincFocus (60)), robust = evaluate (robustFocus (60, spread));
    INFO ("median " << nominal.fieldError[2] << " and " << robust.fieldError[2] << ", 95 % " << nominal.fieldError[4]
                    << " and " << robust.fieldError[4]);
    CHECK (robust.fieldError[2] < 0.6 * nominal.fieldError[2]);
    CHECK (robust.fieldError[4] < 0.6 * nominal.fieldError[4]);
    CHECK (robust.vScore[0] > nominal.vScore[0]);
}

TEST_CASE ("A focus that is robust gives two envelopes a mode, one where growth is given", "[robust]")
{
    const auto model = test::sineBeam (20, 8);
    auto focus = robustFocus (150, usualSpread);
    CHECK (designFocus (model, focus, {}, DesignExtent::playable).program.oscillations.size() == 2 * 3 * 8);
    focus.transients.growth = { 2 };
    CHECK (designFocus (model, focus, {}, DesignExtent::playable).program.oscillations.size() == 3 * 8);
}
