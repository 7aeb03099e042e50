#include "FreeWaveform.h"

#include "DriveAllocation.h"
#include "QuietWaveform.h"
#include "SlewedWaveform.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto largestGap = 1e-6; // beyond it the least energy was not found

AllocationCertificate makeCertificate (const PlayedWaveform& waveform, std::chrono::duration<double, std::milli> time)
{
    const auto& solution = waveform.free;
    AllocationCertificate certificate;
    certificate.peakRatio = waveform.peak;
    certificate.status = waveform.isLimited ? AllocationStatus::optimal : AllocationStatus::unconstrained;
    certificate.iterations = solution.iterations;
    certificate.objective = solution.objective;
    certificate.bound = solution.bound;
    certificate.gap =
        solution.objective > 0 ? std::max (0.0, (solution.objective - solution.bound) / solution.objective) : 0;
    certificate.minimumPeakRatio = solution.peakBound;
    certificate.rowResidual = solution.rowResidual;
    certificate.milliseconds = time.count();
    return certificate;
}
} // namespace

FreeWaveform freeWaveform (const ModalModel& model, const FocusDescription& description, const std::vector<int>& modes,
                           const Eigen::VectorXd& wanted, const Eigen::VectorXd& limits, Playback playback)
{
    const auto start = std::chrono::steady_clock::now();
    const auto guards = guardModes (model, modes, description.allocation);
    const WaveformTask task { model, description, modes, guards, wanted, limits, playback };
    auto [solved, edgeTime] =
        hasSlewLimits (model) ? solveWithinSlews (task) : std::pair (solveWithEdges (task, 0), 0.0);
    auto& [problem, waveform] = solved;
    auto certificate = makeCertificate (waveform, std::chrono::steady_clock::now() - start);

    if (! (certificate.gap <= largestGap))
        throwTooNear (largestLimitField (task), limits.maxCoeff(), 1);

    FreeWaveform result { std::move (waveform.played), certificate, edgeTime, waveform.tolerantBound, {} };

    if (description.felt && description.allocation.method == AllocationMethod::freeWaveform)
    {
        auto felt = modes;
        felt.insert (felt.end(), guards.begin(), guards.end());
        makeQuieter (result, { model, description, problem.all, felt, problem.sparse.range });
    }

    return result;
}
} // namespace antinode
