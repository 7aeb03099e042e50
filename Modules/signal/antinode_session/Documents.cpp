#include "Documents.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/FingerFile.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_documents/Library.h>
#include <antinode_focus/DriveAllocation.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace antinode
{
DeviceDocument readDeviceDocument (const nlohmann::json& json, const std::string& source)
{
    return { json.dump(), readDevice (json, source) };
}

std::shared_ptr<const DesignDocument> readDesignDocument (const nlohmann::json& json, const std::string& source)
{
    return std::make_shared<const DesignDocument> (DesignDocument {
        json.dump(), source, std::make_shared<const nlohmann::json> (json), readDesignOrigin (json, source) });
}

FocusDocument readFocusDocument (const nlohmann::json& json, const std::string& source)
{
    if (isDesignFile (json))
    {
        auto design = readDesignDocument (json, source);
        return { json["focus"].dump(), design->origin.focus, design };
    }

    return { json.dump(), readFocus (json, source) };
}

std::shared_ptr<const DeviceDocument> deviceDocument (const std::string& nameOrFile)
{
    return std::make_shared<const DeviceDocument> (readDeviceDocument (
        loadDocument (LibraryKind::device, nameOrFile), documentSource (LibraryKind::device, nameOrFile)));
}

std::shared_ptr<const FocusDocument> focusDocument (const std::string& nameOrFile)
{
    return std::make_shared<const FocusDocument> (readFocusDocument (loadDocument (LibraryKind::focus, nameOrFile),
                                                                     documentSource (LibraryKind::focus, nameOrFile)));
}

bool sayTheSame (const FocusDocument& one, const FocusDocument& other)
{
    const auto hasDesign = one.design != nullptr, otherHasDesign = other.design != nullptr;
    return one.text == other.text && hasDesign == otherHasDesign
           && (one.design == other.design || one.design->text == other.design->text);
}

FocusDocument withFingers (const FocusDocument& focus, const std::vector<Finger>& fingers)
{
    auto json = nlohmann::json::parse (focus.text);
    json.erase ("fingers");

    for (const auto& finger : fingers)
        json["fingers"].push_back (nlohmann::json (fingerToJson (finger)));

    auto changed = readFocusDocument (json, "focus");
    changed.design = focus.design;
    return changed;
}

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

std::shared_ptr<const ModalModel> withAmplifiers (const std::shared_ptr<const ModalModel>& model,
                                                  const std::vector<double>& volts)
{
    if (std::all_of (volts.begin(), volts.end(), [] (double each) { return each == 0; }))
        return model;

    auto result = std::make_shared<ModalModel> (*model);

    for (std::size_t i = 0; i < std::min (volts.size(), result->ceramics.size()); ++i)
        result->ceramics[i].amplifierVoltage = volts[i];

    return result;
}
} // namespace antinode
