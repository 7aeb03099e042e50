#include "MeasuredDevice.h"

#include "DeviceFile.h"
#include "FileUnits.h"
#include "SharedFields.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/WholeFile.h>
#include <antinode_structure/MeasuredModel.h>
#include <antinode_text/JsonReader.h>
#include <antinode_text/JsonText.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace antinode
{
namespace
{
constexpr NumberRange anyParticipation { -1e12, 1e12 };

std::vector<std::string> ceramicNames (const DeviceDescription& drawing)
{
    std::vector<std::string> names;
    std::visit (
        [&] (const auto& body)
        {
            if constexpr (requires { body.common; })
                for (const auto& ceramic : body.common.ceramics)
                    names.push_back (ceramic.name.empty() ? "C" + std::to_string (names.size() + 1) : ceramic.name);
        },
        drawing.body);
    return names;
}

/** Real parts, and of a complex mode imaginary parts below. */
Eigen::MatrixXd readParticipation (const JsonObject& mode, std::size_t ceramics)
{
    const auto imaginary = mode.optional ("participation_imaginary_per_V");
    Eigen::MatrixXd participation (imaginary ? 2 : 1, static_cast<Eigen::Index> (ceramics));
    const auto read = [&] (Eigen::Index row, const JsonValue& list)
    {
        const auto numbers = list.numbers (ceramics, ceramics, anyParticipation);
        participation.row (row) = Eigen::Map<const Eigen::RowVectorXd> (numbers.data(), participation.cols());
    };
    read (0, mode.required ("participation_per_V"));

    if (imaginary)
        read (1, *imaginary);

    return participation;
}

MeasuredMode readMode (const JsonValue& value, std::size_t ceramics)
{
    const auto object =
        value.object ({ "base_mode", "frequency_Hz", "damping_ratio", "quality_factor", "participation_per_V",
                        "participation_imaginary_per_V", "base_sign", "base_shares" });
    MeasuredMode mode;
    mode.drawn = object.required ("base_mode").integer (1, static_cast<int> (ranges::maximumModes)) - 1;
    mode.angularFrequency = fromHertz (object.required ("frequency_Hz").number (ranges::frequencyHz));
    mode.dampingRatio = readDampingRatio (object);
    mode.participation = readParticipation (object, ceramics);

    if (const auto given = object.optional ("base_sign"))
    {
        const auto sign = given->object ({ "ceramic", "participation_per_V" });
        mode.reference = { sign.required ("ceramic").integer (1, static_cast<int> (std::max<std::size_t> (1, ceramics)))
                               - 1,
                           sign.required ("participation_per_V").number (anyParticipation) };

        if (ceramics == 0)
            given->fail ("is given, but the base has no ceramics; allowed: with ceramics");
    }

    if (const auto given = object.optional ("base_shares"))
        for (const auto& each : given->items (1, ranges::maximumModes))
        {
            const auto share = each.object ({ "base_mode", "share" });
            mode.shares.push_back (
                { share.required ("base_mode").integer (1, static_cast<int> (ranges::maximumModes)) - 1,
                  share.required ("share").number ({ -2, 2 }) });
        }

    return mode;
}

std::vector<MeasuredMode> readModes (const JsonValue& list, std::size_t ceramics)
{
    std::vector<MeasuredMode> modes;
    std::set<Eigen::Index> drawn;

    for (const auto& value : list.items (1, ranges::maximumModes))
    {
        modes.push_back (readMode (value, ceramics));

        if (! drawn.insert (modes.back().drawn).second)
            value.required ("base_mode").fail ("is given to two modes; allowed: a mode of the base once");
    }

    sortByFrequency (modes);
    return modes;
}

MeasuredCeramic readMeasuredCeramic (const JsonValue& value, const std::string& name, const VoltageLimits& limits)
{
    const auto object = value.object ({ "name", "voltage_limit_V", "slew_limit_V_per_us", "lag" });
    MeasuredCeramic ceramic;

    if (const auto given = object.optional ("name"); given && ! given->isWord (name))
        given->fail (given->description() + "; allowed: " + inQuotes (name) + ", which is its name in the base");

    if (const auto limit = object.optional ("voltage_limit_V"))
        ceramic.voltageLimit = limit->number ({ 0, limits.voltage });

    if (const auto slew = object.optional ("slew_limit_V_per_us"))
        ceramic.slewLimit = fromVoltsPerMicrosecond (slew->number (ranges::slewVoltsPerMicrosecond));

    if (const auto lag = object.optional ("lag"))
        ceramic.lag = readLag (*lag);

    return ceramic;
}

nlohmann::ordered_json modeToJson (const MeasuredMode& mode)
{
    nlohmann::ordered_json json { { "base_mode", mode.drawn + 1 },
                                  { "frequency_Hz", toHertz (mode.angularFrequency) },
                                  { "damping_ratio", mode.dampingRatio },
                                  { "participation_per_V", toJsonList (mode.participation.row (0)) } };

    if (mode.participation.rows() > 1)
        json["participation_imaginary_per_V"] = toJsonList (mode.participation.row (1));

    if (mode.reference)
        json["base_sign"] = { { "ceramic", mode.reference->ceramic + 1 },
                              { "participation_per_V", mode.reference->participation } };

    for (const auto& each : mode.shares)
        json["base_shares"].push_back ({ { "base_mode", each.drawn + 1 }, { "share", each.share } });

    return json;
}

nlohmann::ordered_json ceramicToJson (const std::string& name, const MeasuredCeramic& ceramic)
{
    nlohmann::ordered_json json { { "name", name } };

    if (ceramic.voltageLimit)
        json["voltage_limit_V"] = *ceramic.voltageLimit;

    if (ceramic.slewLimit)
        json["slew_limit_V_per_us"] = toVoltsPerMicrosecond (*ceramic.slewLimit);

    if (ceramic.lag != InputLag {})
        json["lag"] = lagToJson (ceramic.lag);

    return json;
}
} // namespace

MeasuredDevice readMeasuredDevice (const JsonValue& device, std::shared_ptr<const DeviceDescription> drawing)
{
    const auto body =
        device.object ({ "schema", "name", "description", "limits", "base", "modes", "ceramics", originKey });
    const auto limits = readLimits (body.required ("limits"));
    const auto names = ceramicNames (*drawing);
    MeasuredDevice measured {
        std::move (drawing), readModes (body.required ("modes"), names.size()), {}, { ModeSource::retuned }
    };

    if (const auto origin = body.optional (originKey))
        measured.origin = readOrigin (*origin);

    if (const auto list = body.optional ("ceramics"))
        for (const auto& ceramic : list->items (names.size(), names.size()))
            measured.ceramics.push_back (readMeasuredCeramic (ceramic, names[measured.ceramics.size()], limits));

    return measured;
}

void measuredToJson (nlohmann::ordered_json& device, const MeasuredDevice& measured)
{
    const auto names = ceramicNames (*measured.drawing);
    device[originKey] = originToJson (measured.origin);
    device["ceramics"] = nlohmann::ordered_json::array();

    for (std::size_t i = 0; i < measured.ceramics.size(); ++i)
        device["ceramics"].push_back (ceramicToJson (names[i], measured.ceramics[i]));

    device["modes"] = nlohmann::ordered_json::array();

    for (const auto& mode : measured.modes)
        device["modes"].push_back (modeToJson (mode));
}

namespace
{
using Json = nlohmann::ordered_json;

/** Behind what a device's user says of it, in a line of its own; said twice it is there once. */
std::string withChange (const std::string& description, const std::string& change)
{
    if (description.empty() || description == change)
        return change;

    if (description.ends_with ("\n" + change) || description.size() + change.size() >= ranges::maximumDescriptionBytes)
        return description;

    return description + "\n" + change;
}

/** A drawn device, without what stands in the device that it is the base of. */
Json baseOf (Json document)
{
    if (document.contains ("base"))
        return document["base"];

    for (const auto* const key : { "schema", "name", "description", "limits" })
        document.erase (key);

    return document;
}
} // namespace

std::string deviceText (const nlohmann::ordered_json& device)
{
    auto text = readableJson (device);
    const auto name = "device '" + device.value ("name", "") + "'";

    if (const auto most = FileKind {}.maximumBytes; text.size() > most)
        throw InputError (name, "would be a file of " + std::to_string (text.size() >> 20)
                                    + " MiB, which is not read again; allowed: up to " + std::to_string (most >> 20)
                                    + " MiB, with fewer points or modes");

    try
    {
        readDevice (parseJson (text, name), name);
    }
    catch (const InputError& error)
    {
        throw InputError ("the device is not written, since it could not be read", error.what());
    }

    return text;
}

nlohmann::ordered_json limitsInFile (const DeviceDescription& device)
{
    return device.document.empty() ? Json() : Json::parse (device.document)["limits"];
}

std::string changedDeviceText (const DeviceDescription& device, const ModalModel& before, const ModalModel& now,
                               const std::string& change)
{
    const auto description = withChange (device.description, change);
    const auto measured = measuredChanges (device, before, now);

    if (! measured || device.document.empty())
        return deviceText (modalDeviceToJson (now, description, limitsInFile (device)));

    Json changed { { "schema", "antinode.device/1" },
                   { "name", device.name },
                   { "description", description },
                   { "limits", limitsInFile (device) } };
    measuredToJson (changed, *measured);
    changed["base"] = baseOf (Json::parse (device.document));
    return deviceText (changed);
}

nlohmann::ordered_json identifiedDeviceToJson (const ModalModel& model, const IdentifiedModes& modes,
                                               const std::string& description, const nlohmann::ordered_json& limits)
{
    auto device = modalDeviceToJson (model, description, limits);
    const auto& deviations = modes.deviations;
    const auto areKnown = [&] (const auto& values) { return values.rows() == model.modes() && values.allFinite(); };
    device["delay_s"] = modes.delay;

    if (deviations.delay > 0 && std::isfinite (deviations.delay))
        device["delay_standard_deviation_s"] = deviations.delay;

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        auto& mode = device["modes"][static_cast<std::size_t> (k)];

        if (areKnown (deviations.angularFrequencies))
            mode["frequency_standard_deviation_Hz"] = toHertz (deviations.angularFrequencies[k]);

        if (areKnown (deviations.dampingRatios))
            mode["damping_ratio_standard_deviation"] = deviations.dampingRatios[k];

        if (areKnown (deviations.participation))
            mode["participation_standard_deviation_per_V"] = toJsonList (deviations.participation.row (k));
    }

    return device;
}
} // namespace antinode
