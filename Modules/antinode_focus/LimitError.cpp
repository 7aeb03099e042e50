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

LimitError::LimitError (const std::string& where, const std::string& wrong, double leastPeakVoltageToUse,
                        double reachableVelocityToUse)
    : InputError (where, wrong), leastPeakVoltage (leastPeakVoltageToUse), reachableVelocity (reachableVelocityToUse)
{
}

void throwWhereBeyondLimit (const AllocationCertificate& certificate, AllocationMethod method,
                            const Eigen::VectorXd& limits, double peakVelocity, bool hasSlewLimits)
{
    const auto isBeyond = certificate.status == AllocationStatus::infeasible
                          || (traitsOf (method).asksForLeastPeak && certificate.peakRatio > 1);

    if (! isBeyond)
        return;

    const auto ratio = certificate.peakRatio;
    const auto least = limits.maxCoeff() * ratio;
    const auto reachable = peakVelocity / ratio;
    const auto needed = hasSlewLimits ? "these drives need " + inWords (ratio) + " times these limits, which allow "
                                      : "these drives need at least " + inWords (least) + " V; this limit allows ";
    const auto* const wayOut = traitsOf (method).waveforms == AllocatedWaveforms::dictionary
                                   ? ""
                                   : "; the allocation 'dictionary' may reach more"; // has most drives
    throw LimitError ("focus: voltage limit",
                      "is " + inWords (limits.maxCoeff()) + (hasSlewLimits ? " V within the slew limits" : " V")
                          + ", too low for " + inWords (millimetresPerSecond (peakVelocity)) + " mm/s: " + needed
                          + inWords (millimetresPerSecond (reachable)) + " mm/s" + wayOut,
                      least, reachable);
}
} // namespace antinode
