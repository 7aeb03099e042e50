#include "DriveAllocation.h"

#include "ModeDrives.h"
#include "RobustRows.h"
#include "StateRows.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
double firstStart (const DriveList& drives)
{
    auto first = drives.front().front().start;

    for (const auto& drive : drives)
        first = std::min (first, drive.front().start);

    return first;
}

/** V/s; for ceramics without a limit what they can never reach. */
Eigen::VectorXd slewLimits (const ModalModel& model, const Eigen::MatrixXd& slopes)
{
    constexpr auto farBeyond = 1e6;
    Eigen::VectorXd limits (model.actuators());

    for (Eigen::Index i = 0; i < limits.size(); ++i)
    {
        const auto& ceramic = model.ceramics[static_cast<std::size_t> (i)];
        limits[i] =
            ceramic.slewLimit > 0 ? ceramic.slewLimit : farBeyond * ceramic.voltageLimit * slopes.cwiseAbs().maxCoeff();
    }

    return limits;
}

/** A quantity of modes at every moment, moment by moment. */
std::vector<StateRow> rowsOver (const std::vector<int>& modes, const std::vector<FocusMoment>& moments,
                                ModalQuantity quantity)
{
    std::vector<StateRow> rows;

    for (const auto& moment : moments)
    {
        const auto more = rowsAt (moment.time, modes, quantity);
        rows.insert (rows.end(), more.begin(), more.end());
    }

    return rows;
}

std::vector<int> timesOver (const std::vector<int>& modes, const std::vector<FocusMoment>& moments)
{
    std::vector<int> all;

    for (std::size_t i = 0; i < moments.size(); ++i)
        all.insert (all.end(), modes.begin(), modes.end());

    return all;
}

Eigen::VectorXd stackWanted (const std::vector<FocusMoment>& moments)
{
    Eigen::VectorXd wanted (0);

    for (const auto& moment : moments)
    {
        wanted.conservativeResize (wanted.size() + moment.wanted.size());
        wanted.tail (moment.wanted.size()) = moment.wanted;
    }

    return wanted;
}

/** Hard rows of the same modes that want 0. */
void addDisplacementRows (AllocationProblem& problem, const Eigen::MatrixXd& responses)
{
    const auto count = responses.rows();
    const Eigen::MatrixXd participation = problem.participation;
    problem.participation = participation.replicate (2, 1);
    problem.rows.conservativeResize (2 * count, Eigen::NoChange);
    problem.rows.bottomRows (count) = responses;
    problem.wanted.conservativeResize (2 * count);
    problem.wanted.tail (count).setZero();
}

/** Modes that a device does not say are asked to be at rest: guards would trade them against volts, or be ignored for
   the peak. Robust rows have no place for them, so that they are guarded there. */
std::vector<int> takeModesAtRest (std::vector<int>& guards, const FocusDescription& description)
{
    std::vector<int> atRest;

    if (description.allocation.robust || ! description.modes.among)
        return atRest;

    const auto first = std::lower_bound (guards.begin(), guards.end(), *description.modes.among);
    atRest.assign (first, guards.end());
    guards.erase (first, guards.end());
    return atRest;
}

/** Further hard rows of modes that want 0. */
void addRowsAtRest (AllocationProblem& problem, const Eigen::MatrixXd& participation, const Eigen::MatrixXd& responses)
{
    const auto count = problem.rows.rows();
    problem.participation.conservativeResize (count + participation.rows(), Eigen::NoChange);
    problem.participation.bottomRows (participation.rows()) = participation;
    problem.rows.conservativeResize (count + responses.rows(), Eigen::NoChange);
    problem.rows.bottomRows (responses.rows()) = responses;
    problem.wanted.conservativeResize (count + responses.rows());
    problem.wanted.tail (responses.rows()).setZero();
}

AllocationProblem allocationProblem (const DriveTask& task, const DriveList& drives, DriveSpan span)
{
    const auto& [model, description, modes, moments, playback] = task;
    const auto& choice = description.allocation;

    AllocationProblem problem;
    limitDrives (problem, model, voltageLimits (model, choice), drives, span);
    problem.wanted = stackWanted (moments);
    problem.participation = model.participation (timesOver (modes, moments), Eigen::all);

    if (choice.method == AllocationMethod::paper)
    {
        problem.rows = Eigen::MatrixXd::Identity (problem.wanted.size(), problem.wanted.size());
        return problem;
    }

    auto guards = guardModes (model, modes, choice);
    const auto atRest = takeModesAtRest (guards, description);
    const auto hardRows = rowsOver (modes, moments, ModalQuantity::velocity);
    const auto guardRows = rowsOver (guards, moments, ModalQuantity::velocity);
    problem.rows = rowResponses (model, hardRows, drives, playback);
    problem.guardWeight = choice.guardWeight;

    if (model.hasComplexModes())
    {
        auto turned = rowsOver (modes, moments, ModalQuantity::turnedVelocity);
        const auto turnedGuards = rowsOver (guards, moments, ModalQuantity::turnedVelocity);
        turned.insert (turned.end(), turnedGuards.begin(), turnedGuards.end());
        addComplexRows (problem, model, { hardRows, guardRows, turned }, drives, playback);
        return problem;
    }

    problem.guardParticipation = model.participation (timesOver (guards, moments), Eigen::all);
    problem.guardRows = rowResponses (model, guardRows, drives, playback);

    if (choice.isUndisplaced)
        addDisplacementRows (
            problem, rowResponses (model, rowsOver (modes, moments, ModalQuantity::displacement), drives, playback));

    if (! atRest.empty())
        addRowsAtRest (problem, model.participation (timesOver (atRest, moments), Eigen::all),
                       rowResponses (model, rowsOver (atRest, moments, ModalQuantity::velocity), drives, playback));

    if (choice.robust)
        return withRobustRows (std::move (problem), model, { modes, guards, drives, moments.front().time, playback },
                               *choice.robust);

    return problem;
}
} // namespace

Eigen::VectorXd voltageLimits (const ModalModel& model, const AllocationChoice& choice)
{
    const auto limits = voltageLimits (model);
    return choice.voltageLimit ? Eigen::VectorXd (limits.cwiseMin (*choice.voltageLimit)) : limits;
}

bool hasSlewLimits (const ModalModel& model)
{
    return std::any_of (model.ceramics.begin(), model.ceramics.end(),
                        [] (const auto& ceramic) { return ceramic.slewLimit > 0; });
}

void limitDrives (AllocationProblem& problem, const ModalModel& model, const Eigen::VectorXd& limits,
                  const DriveList& drives, DriveSpan span)
{
    problem.waveforms = sampleDrives (drives, span.first, span.last);
    problem.voltageLimits = limits * gridLimitMargin();

    if (! hasSlewLimits (model))
        return;

    problem.slopes = sampleSlopes (drives, span.first, span.last);
    problem.slewLimits = slewLimits (model, problem.slopes) * gridLimitMargin();
}

std::vector<int> guardModes (const ModalModel& model, const std::vector<int>& controlled,
                             const AllocationChoice& choice)
{
    std::vector<int> guards;

    for (int k = 0; k < model.modes(); ++k)
        if (! std::binary_search (controlled.begin(), controlled.end(), k))
            guards.push_back (k);

    if (choice.guardModes && *choice.guardModes < static_cast<int> (guards.size()))
        guards.resize (static_cast<std::size_t> (*choice.guardModes));

    return guards;
}

double longestDrive (const FocusDescription& description)
{
    const auto time = description.focusTime;
    return std::min ({ time, description.transients.maximumDuration.value_or (time),
                       description.allocation.window.value_or (time) });
}

Allocation allocateDrives (const DriveTask& task, const DriveList& drives)
{
    const auto& choice = task.description.allocation;
    const auto& moments = task.moments;
    const auto start = firstStart (drives);
    const auto first = choice.window ? std::max (moments.front().time - *choice.window, start) : start;
    const DriveSpan span { first, moments.back().time + releaseDuration() };
    return solveAllocation (allocationProblem (task, drives, span), AllocationGoal::norm);
}

/** A drive's oscillations share its column of the matrix. */
VoltageProgram makeProgram (const DriveList& drives, const Eigen::MatrixXd& matrix, const Eigen::VectorXd& limits,
                            double focusTime)
{
    VoltageProgram program;
    std::vector<Eigen::Index> columns;

    for (std::size_t l = 0; l < drives.size(); ++l)
        for (const auto& oscillation : drives[l])
        {
            program.oscillations.push_back (oscillation);
            columns.push_back (static_cast<Eigen::Index> (l));
        }

    program.allocation = matrix (Eigen::all, columns);
    program.voltageLimits = limits;
    program.focusTime = focusTime;
    return program;
}

namespace
{
/** The instants of the grid: the last one is exact, whatever the others' rounding. */
struct SampleTimes
{
    double last, duration, steps;

    double at (Eigen::Index n) const { return last - duration * (1 - static_cast<double> (n) / steps); }
    double interval() const { return duration / steps; }
};

/** A phasor rotated from sample to sample, and recomputed often enough to limit rounding. */
void addSamples (Eigen::Ref<Eigen::RowVectorXd, 0, Eigen::InnerStride<>> samples, const Oscillation& oscillation,
                 const SampleTimes& times)
{
    constexpr Eigen::Index renewal = 64;
    const auto turn = std::exp (oscillation.exponent() * times.interval());
    std::complex<double> phasor;
    Eigen::Index turned = renewal;

    for (Eigen::Index n = 0; n < samples.size(); ++n)
    {
        const auto time = times.at (n);

        if (time < oscillation.start || time >= oscillation.end)
            continue;

        phasor = turned < renewal
                     ? phasor * turn
                     : oscillation.phasor() * std::exp (oscillation.exponent() * (time - oscillation.start));
        turned = turned < renewal ? turned + 1 : 1;
        samples[n] += phasor.real();
    }
}

/** Memory that is touched for the first time takes long: the watch is looked at between pieces. */
Eigen::MatrixXd makeZeros (Eigen::Index rows, Eigen::Index columns)
{
    constexpr Eigen::Index piece = 2048;
    Eigen::MatrixXd zeros (rows, columns);

    for (Eigen::Index first = 0; first < columns; first += piece)
    {
        checkWatch();
        zeros.middleCols (first, std::min (piece, columns - first)).setZero();
    }

    return zeros;
}

/** The oscillation whose value is the slope of the given one. */
Oscillation differentiated (Oscillation oscillation)
{
    const auto phasor = oscillation.exponent() * oscillation.phasor();
    oscillation.inPhase = -phasor.imag();
    oscillation.quadrature = phasor.real();
    return oscillation;
}
} // namespace

double gridLimitMargin()
{
    return std::cos (std::numbers::pi / gridSamplesPerCycle);
}

Eigen::MatrixXd sampleSlopes (const std::vector<std::vector<Oscillation>>& drives, double first, double last,
                              int samplesPerCycle)
{
    auto slopes = drives;

    for (auto& drive : slopes)
        for (auto& oscillation : drive)
            oscillation = differentiated (oscillation);

    return sampleDrives (slopes, first, last, samplesPerCycle);
}

Eigen::MatrixXd sampleDrives (const std::vector<std::vector<Oscillation>>& drives, double first, double last,
                              int samplesPerCycle)
{
    double highest = 0;

    for (const auto& drive : drives)
        for (const auto& oscillation : drive)
            highest = std::max (highest, std::abs (oscillation.exponent()) / (2 * std::numbers::pi));

    const auto steps = std::max (2.0, std::ceil ((last - first) * highest * samplesPerCycle));
    auto samples = makeZeros (static_cast<Eigen::Index> (drives.size()), static_cast<Eigen::Index> (steps) + 1);

    const SampleTimes times { last, last - first, steps };

    for (Eigen::Index l = 0; l < samples.rows(); ++l)
        for (const auto& oscillation : drives[static_cast<std::size_t> (l)])
        {
            checkWatch();
            addSamples (samples.row (l), oscillation, times);
        }

    return samples;
}
} // namespace antinode
