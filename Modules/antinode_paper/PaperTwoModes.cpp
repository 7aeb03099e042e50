#include "PaperTwoModes.h"

#include <antinode_focus/DesignFocus.h>

#include <limits>

namespace antinode
{
namespace
{
// The print counts the modes that its vibrometer saw; the sway mode between its second and third is computed here as
// well.
const std::vector<int> studiedModes { 0, 3 };
constexpr double velocityEach = 0.02;  // m/s
constexpr double twoModeRate = 192000; // Hz
constexpr double freeLimit = 1e5;      // V: no limit

FocusDescription twoModeFocus (DriveKind drive, double limit, AllocationMethod method)
{
    FocusDescription description;
    description.name = "two modes";
    description.focusTime = 0.05; // ten cycles of mode 1 take 26 ms here, so the later of the paper's two instants
    description.transients.drive = drive;
    description.transients.growth = { 4, 1 };
    description.transients.cycles = { 10, 25 };
    description.allocation.method = method;
    description.allocation.voltageLimit = limit;
    description.probes = { { 0, 0 } };
    return description;
}

ModalModel withCeramics (const ModalModel& model, int first, int second)
{
    auto result = model;
    result.participation = model.participation (Eigen::all, std::vector<int> { first, second });
    result.ceramics = { model.ceramics[static_cast<std::size_t> (first)],
                        model.ceramics[static_cast<std::size_t> (second)] };
    return result;
}

Eigen::VectorXd wantedVelocities (const ModalModel& model)
{
    const Eigen::RowVectorXd shapes = shapesAt (model, 0, 0);
    return velocityEach * shapes (studiedModes).cwiseInverse().transpose();
}

double peakOfPair (ModalModel model)
{
    model.fullScaleVoltage = freeLimit;

    for (auto& ceramic : model.ceramics)
        ceramic.voltageLimit = freeLimit;

    return peakVoltage (designModes (model, twoModeFocus (DriveKind::offsetFree, freeLimit, AllocationMethod::paper),
                                     studiedModes, wantedVelocities (model), {}));
}

ModalModel bestPair (const ModalModel& model)
{
    auto minimum = std::numeric_limits<double>::infinity();
    auto best = model;

    for (int first = 0; first < model.actuators(); ++first)
        for (int second = first + 1; second < model.actuators(); ++second)
        {
            auto pair = withCeramics (model, first, second);

            if (const auto peak = peakOfPair (pair); peak < minimum)
            {
                minimum = peak;
                best = std::move (pair);
            }
        }

    return best;
}

TwoModeCase evaluateCase (const ModalModel& model, DriveKind drive, double limit, bool isAllocated)
{
    TwoModeCase result;
    result.drive = drive;
    result.limit = limit;
    result.isAllocated = isAllocated;
    const auto description =
        twoModeFocus (drive, limit, isAllocated ? AllocationMethod::paper : AllocationMethod::oneToOne);
    RenderOptions options;
    options.playback = { Reconstruction::bandLimited, twoModeRate };

    try
    {
        const auto design = designModes (model, description, studiedModes, wantedVelocities (model), options.playback);
        result.peakVoltage = peakVoltage (design);
        result.result = renderFocus (model, design, options);
    }
    catch (const LimitError& error)
    {
        result.minimumPeakVoltage = error.minimumPeakVoltage;
        result.reachableVelocity = 2 * velocityEach * limit / error.minimumPeakVoltage;
    }

    return result;
}
} // namespace

TwoModeStudy evaluateTwoModes (const ModalModel& model)
{
    const auto pair = bestPair (model);
    TwoModeStudy study;

    for (const auto& ceramic : pair.ceramics)
        study.ceramics.push_back (ceramic.name);

    for (const auto mode : studiedModes)
        study.frequencies.push_back (model.frequencyHz (mode));

    for (const auto drive : { DriveKind::paper, DriveKind::offsetFree })
        for (const auto limit : { 20.0, 50.0 })
            for (const auto isAllocated : { false, true })
                study.cases.push_back (evaluateCase (pair, drive, limit, isAllocated));

    return study;
}
} // namespace antinode
