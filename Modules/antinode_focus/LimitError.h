#pragma once

#include "FocusDescription.h"

#include <antinode_allocation/Allocation.h>
#include <antinode_base/InputError.h>

namespace antinode
{
/** The wanted focus cannot be reached within the voltage limit. The text gives the lowest feasible voltage and the
    highest feasible velocity. */
class LimitError : public InputError
{
public:
    LimitError (const std::string& where, const std::string& wrong, double minimumPeakVoltageToUse,
                double reachableVelocityToUse);

    double minimumPeakVoltage; ///< V: the least peak of these drives that reaches the wanted field.
    double reachableVelocity;  ///< m/s: the peak velocity that the limit allows.
};

/** @param limits        N_b, V
    @param peakVelocity  what was wanted, m/s
    @param hasSlewLimits whether there are slew limits besides
    @throws LimitError   when an allocation shows that the limits cannot be met
    [worker] */
void throwWhereBeyondLimit (const AllocationCertificate&, AllocationMethod, const Eigen::VectorXd& limits,
                            double peakVelocity, bool hasSlewLimits);
} // namespace antinode
