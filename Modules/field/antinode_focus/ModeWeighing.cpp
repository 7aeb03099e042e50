#include "ModeWeighing.h"

#include "FocusDesign.h"
#include "Projection.h"

#include <antinode_base/MessageText.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>

namespace antinode
{
namespace
{
constexpr double cheapShare = 0.25;      // of the limits: below it more modes are not worth their time
constexpr double noticeableShare = 1.05; // of the least need: fewer modes are preferred within it
constexpr double usableShareOfNyquist = 0.8;
constexpr std::array triedMultiples { 1.25, 1.5, 2.0, 3.0 };

std::string needInWords (const FocusDesign& design)
{
    return std::to_string (design.controlledModes.size()) + " capture " + inWords (design.captured) + " and need "
           + inWords (design.certificate.peakVoltage) + " V";
}

bool suitsRate (const FocusDesign& design, const ModalModel& model)
{
    const auto rate = design.playback.sampleRate;
    return rate <= 0 || model.frequencyHz (design.controlledModes.back()) <= usableShareOfNyquist * 0.5 * rate;
}

/** Designs with more modes than a number, as far as there are any and they keep the limits. */
std::vector<FocusDesign> richerDesigns (const ModalModel& model, const ModeTrials& trials, std::size_t fewest)
{
    std::vector<FocusDesign> designs;
    auto last = static_cast<int> (fewest);

    const auto shown = static_cast<int> (resolvedModes (model));

    for (const auto multiple : triedMultiples)
    {
        ModeChoice choice;
        choice.count = std::min (static_cast<int> (std::ceil (multiple * static_cast<double> (fewest))), shown);

        if (shown < model.modes())
            choice.among = shown;

        if (*choice.count <= last)
            break;

        last = *choice.count;

        try
        {
            if (auto chosen = trials.choose (choice); suitsRate (chosen, model))
                designs.push_back (trials.allocate (std::move (chosen)));
        }
        catch (const InputError&)
        {
            // Not so many modes can be excited, steered apart, or brought within the limits.
        }
    }

    return designs;
}

/** The fewest modes that need hardly more than the least. */
std::size_t cheapestDesign (const std::vector<FocusDesign>& designs)
{
    const auto need = [] (const FocusDesign& design) { return design.certificate.peakRatio; };
    const auto least = need (*std::min_element (designs.begin(), designs.end(),
                                                [&] (const auto& a, const auto& b) { return need (a) < need (b); }));
    const auto best = std::find_if (designs.begin(), designs.end(),
                                    [&] (const auto& each) { return need (each) <= noticeableShare * least; });
    return static_cast<std::size_t> (best - designs.begin());
}

FocusDesign weighedDesign (std::vector<FocusDesign> designs, const std::string& refused)
{
    auto sentence = "Numbers of modes that were weighed: " + refused;

    for (const auto& design : designs)
        sentence += (&design == &designs.front() ? "" : "; ") + needInWords (design);

    auto best = std::move (designs[cheapestDesign (designs)]);
    best.weighing = sentence + ". Controlled are " + std::to_string (best.controlledModes.size())
                    + ", the fewest that need at most 5 % more than the least.";
    return best;
}
} // namespace

bool leavesModesOpen (const FocusDescription& description)
{
    const auto& modes = description.modes;
    return ! modes.count && ! modes.captured && ! modes.maximumFrequency && modes.order == ModeOrder::energy
           && description.allocation.method == AllocationMethod::exact && ! description.allocation.robust;
}

FocusDescription withModesOf (FocusDescription description, const FocusDesign& design)
{
    if (leavesModesOpen (description) && design.moments.size() == 1)
        description.modes.count = static_cast<int> (design.controlledModes.size());

    return description;
}

FocusDesign weighModes (const ModalModel& model, const ModeTrials& trials)
{
    auto chosen = trials.choose ({});
    const auto fewest = chosen.controlledModes.size();
    const auto& target = chosen.moments.front().target;
    const auto reachable = target.energy / (target.energy + target.rigidEnergy);
    const auto isWhole = chosen.captured * std::sqrt (reachable) >= defaultCapture();
    std::vector<FocusDesign> designs;
    std::exception_ptr refusal;

    try
    {
        designs.push_back (trials.allocate (std::move (chosen)));
    }
    catch (const LimitError&)
    {
        refusal = std::current_exception();
    }

    if (! refusal && (! isWhole || designs.front().certificate.peakRatio <= cheapShare))
    {
        auto& design = designs.front();
        design.weighing =
            isWhole
                ? "These modes are the fewest that capture 0.99 of the wanted field. They need at most a quarter of "
                  "the limit, so more were not weighed."
                : "All modes that the ceramics excite and the points show are controlled: together they capture less "
                  "than 0.99 of the wanted field, motion as a rigid body included.";
        return std::move (design);
    }

    for (auto& design : richerDesigns (model, trials, fewest))
        designs.push_back (std::move (design));

    if (designs.empty())
        std::rethrow_exception (refusal);

    return weighedDesign (std::move (designs),
                          refusal ? std::to_string (fewest) + " cannot keep the limits; " : std::string());
}
} // namespace antinode
