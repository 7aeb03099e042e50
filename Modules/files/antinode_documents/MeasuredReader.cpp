#include "MeasuredReader.h"

#include "CeramicLag.h"
#include "DampingReader.h"
#include "FileUnits.h"
#include "LimitsReader.h"
#include "OriginReader.h"

#include <antinode_base/MessageText.h>
#include <antinode_structure/MeasuredModel.h>
#include <antinode_text/EigenJson.h>
#include <antinode_text/PhysicalRanges.h>

#include <algorithm>
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
} // namespace antinode
