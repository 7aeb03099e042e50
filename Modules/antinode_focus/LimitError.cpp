#include "LimitError.h"

#include <antinode_base/NumberText.h>

namespace antinode
{
namespace
{
double millimetresPerSecond (double velocity)
{
    return velocity * 1000;
}
} // namespace

LimitError::LimitError (const std::string& where, const std::string& wrong, double minimumPeakVoltageToUse,
                        double reachableVelocityToUse)
    : InputError (where, wrong), minimumPeakVoltage (minimumPeakVoltageToUse),
      reachableVelocity (reachableVelocityToUse)
{
}

void throwWhereBeyondLimit (const AllocationCertificate& certificate, AllocationMethod method,
                            const Eigen::VectorXd& limits, double peakVelocity, bool hasSlewLimits)
{
    const auto isBeyond = certificate.status == AllocationStatus::infeasible
                          || (methodTraits (method).asksForMinimumPeak && certificate.peakRatio > 1);

    if (! isBeyond)
        return;

    const auto ratio = certificate.peakRatio;
    const auto minimum = limits.maxCoeff() * ratio;
    const auto reachable = peakVelocity / ratio;
    const auto needed = hasSlewLimits ? "these drives need " + inWords (ratio) + " times these limits, which allow "
                                      : "these drives need at least " + inWords (minimum) + " V; this limit allows ";
    const auto* const wayOut = methodTraits (method).waveforms == AllocatedWaveforms::dictionary
                                   ? ""
                                   : "; the allocation 'dictionary' may reach more"; // has most drives
    throw LimitError ("focus: voltage limit",
                      "is " + inWords (limits.maxCoeff()) + (hasSlewLimits ? " V within the slew limits" : " V")
                          + ", too low for " + inWords (millimetresPerSecond (peakVelocity)) + " mm/s: " + needed
                          + inWords (millimetresPerSecond (reachable)) + " mm/s" + wayOut,
                      minimum, reachable);
}
} // namespace antinode
