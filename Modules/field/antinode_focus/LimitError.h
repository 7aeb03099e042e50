#pragma once

#include "FocusDesign.h"

#include <antinode_base/InputError.h>

namespace antinode
{
/** The wanted focus cannot be reached within the limits. The text gives what the drives need at least, in the unit of
    the limit, and the highest feasible velocity. */
class LimitError : public InputError
{
public:
    LimitError (const std::string& where, const std::string& wrong, double minimumPeakVoltageToUse,
                double reachableVelocityToUse);

    double minimumPeakVoltage; ///< V: the least peak of these drives that reaches the wanted field.
    double reachableVelocity;  ///< m/s: the peak velocity that the limit allows.
};

/** @param design      with its program, its certificate and the peak velocity that was wanted
    @throws LimitError  when its allocation shows that the limits cannot be met: which one, where, when, and what it
   would take
    [worker] */
void throwWhereBeyondLimit (const FocusDesign& design, const ModalModel&);
} // namespace antinode
