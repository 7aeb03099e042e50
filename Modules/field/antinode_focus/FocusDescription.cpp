#include "FocusDescription.h"

#include <antinode_model/ModalModel.h>

namespace antinode
{
namespace
{
AllocationChoice withExactRows (AllocationChoice choice)
{
    choice.method = AllocationMethod::exact;
    choice.timesBound.reset();
    return choice;
}
} // namespace

AllocationChoice withRetired (AllocationChoice choice, const RetiredMethod& retired)
{
    choice.retired = &retired;
    choice.method = retired.method;
    choice.timesBound.reset();

    if (retired.isUpToLimits)
        choice.timesBound = upToLimits;

    return choice.isUndisplaced ? withExactRows (choice) : choice;
}

AllocationChoice suitedTo (const ModalModel& model, AllocationChoice choice)
{
    const auto needsRealModes = choice.method == AllocationMethod::leastVoltage;
    return model.hasComplexModes() && choice.retired != nullptr && needsRealModes ? withExactRows (choice) : choice;
}

std::string retirementInWords (const AllocationChoice& choice)
{
    if (choice.retired == nullptr)
        return {};

    const auto& retired = *choice.retired;
    const auto isReplaced = choice.method != retired.method;
    const auto used = "'" + std::string (wordFor (allocationMethodWords, choice.method)) + "'";
    const auto key = retired.isUpToLimits && ! isReplaced ? " with 'times_bound' at 'limit'" : "";
    return "The allocation method '" + std::string (retired.word) + "' is no longer offered: " + used + key
           + " is used, which " + (isReplaced ? outcomeOfExact : retired.outcome) + "; write " + used + key + ".";
}
} // namespace antinode
