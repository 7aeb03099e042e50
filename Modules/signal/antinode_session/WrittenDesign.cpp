#include "WrittenDesign.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_focus/DriveAllocation.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace antinode
{
namespace
{
std::string textWithoutFingers (FocusDescription focus)
{
    focus.fingers.clear();
    return focusToJson (focus).dump();
}

bool knowsFingers (const FocusDescription& focus)
{
    return std::any_of (focus.fingers.begin(), focus.fingers.end(), [] (const auto& finger) { return finger.isKnown; });
}
} // namespace

std::shared_ptr<const DesignDocument> writtenFor (const FocusDocument& document, const FocusDescription& wanted)
{
    const auto& design = document.design;
    const auto isWanted = design != nullptr && textWithoutFingers (design->origin.focus) == textWithoutFingers (wanted);
    return isWanted ? design : nullptr;
}

Eigen::VectorXd limitsInPlay (const ModalModel& model, const FocusDescription& focus, const DesignDocument* written)
{
    auto limits = voltageLimits (model, focus.allocation);

    if (written == nullptr || ! written->json->contains ("voltage_limits_V"))
        return limits;

    // What is no number there is refused when the design is read.
    const auto& volts = written->json->at ("voltage_limits_V");

    for (std::size_t i = 0; i < std::min (volts.size(), static_cast<std::size_t> (limits.size())); ++i)
        if (volts[i].is_number())
            limits[static_cast<Eigen::Index> (i)] =
                std::min (limits[static_cast<Eigen::Index> (i)], volts[i].get<double>());

    return limits;
}

FocusDesign designAsWritten (const DesignDocument& document, const ModalModel& model)
{
    return readDesign (*document.json, document.source, model);
}

void requireFit (const FocusDocument& focus, const DeviceDocument& device, const ModalModel* model, Playback playback)
{
    if (focus.design == nullptr)
        return;

    const auto& design = *focus.design;
    const auto& [name, made, isSampled, description] = design.origin;

    if (name != device.description.name)
        throw InputError (design.source, "is for the device '" + name + "', and '" + device.description.name
                                             + "' is loaded; load that device first");

    if (isSampled && playback.sampleRate > 0 && made.sampleRate != playback.sampleRate)
        throw InputError (design.source, "has samples of " + inWords (made.sampleRate) + " Hz, and the host plays "
                                             + inWords (playback.sampleRate)
                                             + " Hz; allowed: that rate, or a new design");

    if (model != nullptr && ! knowsFingers (description))
        designAsWritten (design, *model);
}
} // namespace antinode
