#include "DriveDictionary.h"

#include "DriveGrid.h"
#include "Transients.h"

#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;

/** A thousandth is not enough where modes that are not controlled are near: the field error of the aluminium plate
   falls from 12 % to 0.04 %, and nothing is gained beyond. */
constexpr double roomForGuards = 1.005;

constexpr double greatestFolds = 40; // beyond, an earlier start adds less than 1e-17

/** Re[X e^{p tau} (1 - e^{-r tau})^2] with the phasor that it has at its end, and released there. */
std::vector<Oscillation> dictionaryDrive (int mode, double start, double end, Complex exponent, Complex phasorAtEnd)
{
    const auto phasor = phasorAtEnd * std::exp (exponent * (start - end));
    return playedDrive ({ { mode, start, end, exponent.real(), exponent.imag(), -phasor.imag(), phasor.real() } },
                        DriveStart::smooth);
}
} // namespace

std::vector<double> dictionaryGrowths (std::size_t modes)
{
    constexpr std::size_t few = 24, many = 80;

    if (modes <= few)
        return { 0, 0.3, 1, 3, 8 };

    return modes <= many ? std::vector<double> { 0, 2 } : std::vector<double> { 1 };
}

DriveList dictionaryDrives (const ModalModel& model, const FocusDescription& description, const std::vector<int>& modes,
                            const std::vector<double>& growth)
{
    const auto end = description.focusTime;
    const auto longest = std::min (
        { end, description.transients.maximumDuration.value_or (end), description.allocation.window.value_or (end) });
    const auto decay = decayRates (model);
    const auto frequency = dampedFrequencies (model);
    DriveList drives;

    for (std::size_t i = 0; i < modes.size(); ++i)
        for (const auto multiple : dictionaryGrowths (modes.size()))
        {
            const auto mode = modes[i];
            const Complex exponent (multiple * decay[mode] * std::max (growth[i], 1.0), frequency[mode]);
            const auto duration = std::min (longest, greatestFolds / std::max (exponent.real(), 1e-300));

            for (const auto phase : { Complex (1, 0), Complex (0, -1) })
                drives.push_back (dictionaryDrive (mode, end - duration, end, exponent, phase));
        }

    return drives;
}

Allocation allocateDictionary (AllocationProblem problem, const DriveList& drives, DriveSpan span)
{
    constexpr auto samplesPerCycle = gridSamplesPerCycle / 2;
    const Eigen::VectorXd limits = problem.voltageLimits / gridLimitMargin();
    const auto fine = std::exchange (problem.waveforms, sampleDrives (drives, span.first, span.last, samplesPerCycle));
    problem.voltageLimits = limits * gridLimitMargin (samplesPerCycle);
    problem.peakRoom = roomForGuards;
    auto allocation = solveAllocation (problem, AllocationGoal::peak);
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (allocation.matrix.rows(), fine.cols());
    addProduct (voltages, 1, allocation.matrix, fine);
    auto& certificate = allocation.certificate;
    const Eigen::VectorXd peaks = voltages.cwiseAbs().rowwise().maxCoeff();
    certificate.peakVoltage = peaks.maxCoeff();
    certificate.peakRatio = peaks.cwiseQuotient (limits).maxCoeff() / gridLimitMargin();

    if (problem.slopes.size() > 0)
    {
        Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero (allocation.matrix.rows(), problem.slopes.cols());
        addProduct (slopes, 1, allocation.matrix, problem.slopes);
        const Eigen::VectorXd steepest = slopes.cwiseAbs().rowwise().maxCoeff();
        certificate.peakRatio =
            std::max (certificate.peakRatio, steepest.cwiseQuotient (problem.slewLimits).maxCoeff());
    }

    certificate.minimumPeakRatio *= gridLimitMargin (samplesPerCycle) / gridLimitMargin();
    return allocation;
}
} // namespace antinode
