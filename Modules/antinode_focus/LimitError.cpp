#include "LimitError.h"

#include "DesignRemarks.h"
#include "DriveAllocation.h"

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
                            const Eigen::VectorXd& limits, double peakVelocity)
{
    const auto isBeyond =
        certificate.status == AllocationStatus::infeasible || (asksForLeastPeak (method) && certificate.peakRatio > 1);

    if (! isBeyond)
        return;

    const auto ratio = certificate.peakRatio;
    const auto least = limits.maxCoeff() * ratio;
    const auto reachable = peakVelocity / ratio;
    throw LimitError ("focus: /allocation/voltage_limit_V",
                      inWords (limits.maxCoeff()) + " V cannot bring " + inWords (millimetresPerSecond (peakVelocity))
                          + " mm/s: these drives need at least " + inWords (least) + " V; at this limit "
                          + inWords (millimetresPerSecond (reachable)) + " mm/s can be reached",
                      least, reachable);
}
} // namespace antinode
