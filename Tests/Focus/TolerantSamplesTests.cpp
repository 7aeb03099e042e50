#include "Support/SineBeam.h"

#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Detuning.h>
#include <antinode_focus/Tolerance.h>
#include <antinode_focus/WaveformProblem.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace antinode;

namespace
{
constexpr Playback atInterface { Reconstruction::bandLimited, 48000 };
constexpr DetuningSpread spread { 0.003, 0.1, 0.05, 0 };

FocusDescription robustFocus (double x, bool isRobust, double timesBound = 1.25)
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, x, 0, 0.025, 0.04, 1 } };
    focus.focusTime = 0.02;
    focus.modes.count = 6;
    focus.allocation.method = AllocationMethod::leastVoltage;
    focus.allocation.timesBound = timesBound;

    if (isRobust)
        focus.allocation.robust = Robustness { spread };

    return focus;
}

double medianError (const ModalModel& model, const FocusDesign& design)
{
    const auto tolerance = evaluateTolerance (model, design, { spread, 60, 5 }, [] (double) {});
    return tolerance.fieldError[2];
}
} // namespace

TEST_CASE ("Soft rows of tolerant samples cost what devices that are off err by, on average", "[tolerantSamples]")
{
    // 3000 devices: the mean square is known to 3 %.
    constexpr int devices = 3000;
    constexpr double price = 1e12; // nothing is too weak
    const auto model = test::sineBeam (6, 3);
    std::vector<int> modes { 0, 1, 2, 3, 4, 5 };
    FocusDescription focus;
    focus.focusTime = 0.02;
    const auto sparse = sparseSamples (focus, atInterface, modes.size(), {});
    const Eigen::MatrixXd samples = Eigen::MatrixXd::NullaryExpr (
        3, sparse.range.count,
        [] (Eigen::Index i, Eigen::Index n) { return std::cos (0.3 * static_cast<double> (n * (i + 1) % 57)); });
    const auto velocities = [&] (const ModalModel& device) -> Eigen::VectorXd
    {
        const Eigen::MatrixXd seen = velocityWeights (device, modes, sparse) * samples.transpose();
        return seen.cwiseProduct (device.participation).rowwise().sum();
    };
    const auto known = velocities (model);
    double expected = 0;

    for (int device = 0; device < devices; ++device)
        expected += (velocities (detuned (withoutShapes (model), spread, static_cast<std::uint64_t> (device))) - known)
                        .squaredNorm()
                    / devices;

    BoundedWaveformProblem problem;
    problem.weights = velocityWeights (model, modes, sparse);
    problem.participation = model.participation;
    problem.wanted = known;
    problem.compliance = Eigen::VectorXd::Zero (6);
    const auto tolerant = withTolerance (problem, { model, modes, sparse }, spread, price);
    const Eigen::MatrixXd parts = tolerant.weights * samples.transpose();
    const Eigen::VectorXd rows = parts.cwiseProduct (tolerant.participation).rowwise().sum();
    const auto cost =
        rows.tail (rows.size() - 6).squaredNorm() + parts.cwiseProduct (tolerant.spread).squaredNorm() / price;
    CHECK (cost == Approx (expected).epsilon (0.1));
}

TEST_CASE ("Robust samples are as near to their bound, exact where nothing is off, and err less where it is",
           "[tolerantSamples][leastVoltage]")
{
    const auto model = test::sineBeam (20, 8);

    for (const auto x : { -0.05, 0.01, 0.03 })
    {
        CAPTURE (x);
        const auto plain = designFocus (model, robustFocus (x, false), atInterface);
        const auto robust = designFocus (model, robustFocus (x, true), atInterface);
        CHECK (peakVoltage (robust) <= 1.25 * robust.lowerBoundVoltage);
        CHECK (robust.certificate.rowResidual < 1e-9);
        CHECK (medianError (model, robust) < 0.8 * medianError (model, plain));
        const auto said =
            std::find_if (robust.choices.begin(), robust.choices.end(),
                          [] (const std::string& choice)
                          { return choice.find ("whose expected error is as small") != std::string::npos; });
        CHECK (said != robust.choices.end());
    }
}

TEST_CASE ("Room above the bound makes robust samples more tolerant", "[tolerantSamples][leastVoltage]")
{
    const auto model = test::sineBeam (20, 8);
    const auto near = designFocus (model, robustFocus (0.01, true, 1.1), atInterface, DesignExtent::playable);
    const auto far = designFocus (model, robustFocus (0.01, true, 2.5), atInterface, DesignExtent::playable);
    CHECK (medianError (model, far) < medianError (model, near));
}

TEST_CASE ("Where errors of frequency turn modes by more than a radian, robust samples still err less",
           "[tolerantSamples][leastVoltage]")
{
    // In its time of decay a mode of this quality factor turns by .003 x 2 x 200 = 1.2 rad for each standard deviation.
    const auto model = test::sineBeam (20, 8, 200);
    const auto plain = designFocus (model, robustFocus (0.01, false), atInterface, DesignExtent::playable);
    const auto robust = designFocus (model, robustFocus (0.01, true), atInterface, DesignExtent::playable);
    CHECK (medianError (model, robust) < 0.8 * medianError (model, plain));
}
