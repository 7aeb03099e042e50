#include "FocusDesign.h"

#include "LimitUse.h"

#include <antinode_base/MessageText.h>

namespace antinode
{
namespace
{
/** Limits of which nearly as much is needed as of the one that most is needed of: the least peak touches them all. */
constexpr double touchingShare = 0.98;

std::string velocityInWords (double velocity)
{
    return inWords (velocity * 1000) + " mm/s";
}

/** What a use comes to where it is as large as the least peak. */
std::string minimumAmount (const LimitUse& use, double ratio)
{
    return limitAmount (use.kind, ratio * use.allowed);
}

std::string voltageNeed (const LimitUse& use, double ratio)
{
    return "these drives need at least " + minimumAmount (use, ratio);
}

std::string slewNeed (const ModalModel& model, const LimitUses& uses, double ratio)
{
    const auto need = limitedCeramic (model, *uses.slew) + " needs at least " + minimumAmount (*uses.slew, ratio) + ", "
                      + limitTime (*uses.slew);
    return uses.voltage.share() < touchingShare * ratio
               ? need
               : need + ", and " + limitedCeramic (model, uses.voltage) + " " + minimumAmount (uses.voltage, ratio)
                     + " of its " + limitAmount (uses.voltage.kind, uses.voltage.allowed);
}

/** The allocation that reaches most within the limits, where the model allows it. */
std::string wayOut (const ModalModel& model)
{
    return model.hasComplexModes() ? "" : "; the allocation 'least_voltage' reaches as much as any waveform can";
}
} // namespace

LimitError::LimitError (const std::string& where, const std::string& wrong, double minimumPeakVoltageToUse,
                        double reachableVelocityToUse)
    : InputError (where, wrong), minimumPeakVoltage (minimumPeakVoltageToUse),
      reachableVelocity (reachableVelocityToUse)
{
}

void throwWhereBeyondLimit (const FocusDesign& design, const ModalModel& model)
{
    const auto& certificate = design.certificate;

    if (certificate.status != AllocationStatus::infeasible)
        return;

    const auto ratio = certificate.peakRatio;
    const auto uses = limitUses (model, design.description.allocation, design.program);
    const auto isSlew = uses.slew && uses.slew->share() >= touchingShare * ratio;
    const auto& limit = isSlew ? *uses.slew : uses.voltage;
    const auto reachable = design.reachablePeakVelocity / ratio;
    throw LimitError (limitField (limit.kind),
                      "is " + limitAmount (limit.kind, limit.allowed) + ", too low for "
                          + velocityInWords (design.reachablePeakVelocity) + ": "
                          + (isSlew ? slewNeed (model, uses, ratio) : voltageNeed (limit, ratio))
                          + "; this limit allows " + velocityInWords (reachable) + wayOut (model),
                      design.program.voltageLimits.maxCoeff() * ratio, reachable);
}
} // namespace antinode
