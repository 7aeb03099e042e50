#include "DeviceFile.h"

#include "MeasuredDevice.h"
#include "ModalFile.h"
#include "SharedFields.h"
#include "StructureReader.h"

#include <antinode_base/MessageText.h>
#include <antinode_text/JsonReader.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string_view>

namespace antinode
{
namespace
{
using DeviceBody = decltype (DeviceDescription::body);

DeviceBody readPlateBody (const JsonValue& device)
{
    return std::visit ([] (auto plate) -> DeviceBody { return plate; }, readPlate (device));
}

DeviceBody readBeamBody (const JsonValue& device)
{
    return readBeam (device);
}

DeviceBody readStapleBody (const JsonValue& device)
{
    return readStaple (device);
}

constexpr WordList<DeviceBody (*) (const JsonValue&), 3> drawnKinds {
    { { "plate", &readPlateBody }, { "beam", &readBeamBody }, { "staple", &readStapleBody } }
};

DeviceBody readMeasuredBody (const JsonValue& device)
{
    readLimits (device.required ("limits")); // What is wrong with them stands here, not in the base that gets them.
    const auto base = device.required ("base");
    DeviceDescription drawing;
    drawing.name = device.required ("name").text (ranges::maximumNameBytes);
    drawing.body = base.required ("kind").choice (drawnKinds) (base);
    return readMeasuredDevice (device, std::make_shared<const DeviceDescription> (std::move (drawing)));
}

constexpr WordList<DeviceBody (*) (const JsonValue&), 4> deviceKinds {
    { { "plate", &readPlateBody },
      { "beam", &readBeamBody },
      { "staple", &readStapleBody },
      { "modal", [] (const JsonValue& device) -> DeviceBody { return readModalModel (device); } } }
};

bool hasBase (const nlohmann::json& document)
{
    return document.is_object() && document.contains ("base") && document["base"].is_object();
}

/** A document whose base is whole: what a base may not say itself is what the device says. */
nlohmann::json withWholeBase (nlohmann::json document, const std::string& source)
{
    for (const auto* const key : { "schema", "name", "description", "limits" })
        if (document["base"].contains (key))
            JsonValue (document, source)
                .required ("base")
                .required (key)
                .fail ("is in the base; allowed: in the device that has the base");

    if (document.contains ("limits"))
        document["base"]["limits"] = document["limits"];

    return document;
}

/** A document without what fills it: modes that are given, and their points. */
nlohmann::json withoutModes (const nlohmann::json& document)
{
    constexpr std::array<std::string_view, 5> large { "modes", "points_mm", "weights_kg", "areas_m2", "exact" };
    nlohmann::json kept;

    for (const auto& [key, value] : document.items())
        if (document.value ("kind", "") != "modal" || std::find (large.begin(), large.end(), key) == large.end())
            kept[key] = value;

    return kept;
}
} // namespace

DeviceDescription readDevice (const nlohmann::json& given, const std::string& source)
{
    const auto whole = hasBase (given) ? withWholeBase (given, source) : nlohmann::json();
    const JsonValue device (whole.is_null() ? given : whole, source);
    device.requireSchema ("antinode.device/1");
    DeviceDescription result;
    result.body =
        device.find ("base") ? readMeasuredBody (device) : device.required ("kind").choice (deviceKinds) (device);
    result.requiresArming = readLimits (device.required ("limits")).requiresArming;
    result.name = device.required ("name").text (ranges::maximumNameBytes);

    if (const auto description = device.find ("description"))
        result.description = description->text (ranges::maximumDescriptionBytes, true);

    if (auto* const model = std::get_if<ModalModel> (&result.body))
        model->name = result.name;

    const auto kept = withoutModes (given);
    result.document = kept.dump();
    result.warnings = unlikelyValues (kept);
    return result;
}

namespace
{
/** A unit that a number may be in by mistake, and what it is in the unit of the key. */
struct MistakenUnit
{
    std::string_view name;
    double factor = 0;
};

/** What a key usually says. */
struct UsualRange
{
    std::string_view key;       ///< With the objects that it is in, as far as they matter; the first that fits counts.
    double least = 0, most = 0; ///< Magnitudes that devices have, in the key's unit; 0 is always usual.
    std::array<MistakenUnit, 3> units;
};

constexpr std::array<MistakenUnit, 3> lengths { { { "m", 1e3 }, { "um", 1e-3 }, { "cm", 10 } } };
constexpr std::array<MistakenUnit, 3> moduli { { { "Pa", 1e-9 }, { "MPa", 1e-3 }, { "kPa", 1e-6 } } };

constexpr std::array usualRanges {
    UsualRange { "glue/thickness_mm", 1e-4, 5, lengths },
    UsualRange { "ceramics/thickness_mm", 0.005, 30, lengths },
    UsualRange { "layers/thickness_mm", 0.002, 100, lengths },
    UsualRange { "thickness_mm", 0.02, 100, lengths },
    UsualRange { "length_mm", 0.5, 5000, lengths },
    UsualRange { "width_mm", 0.5, 5000, lengths },
    UsualRange { "length_x_mm", 2, 5000, lengths },
    UsualRange { "length_y_mm", 2, 5000, lengths },
    UsualRange { "top_length_mm", 2, 5000, lengths },
    UsualRange { "leg_length_mm", 0.5, 5000, lengths },
    UsualRange { "size_x_mm", 0.5, 5000, lengths },
    UsualRange { "size_y_mm", 0.5, 5000, lengths },
    UsualRange { "diameter_mm", 0.5, 5000, lengths },
    UsualRange { "youngs_modulus_GPa", 1e-3, 1500, moduli },
    UsualRange { "E1_GPa", 1e-3, 1500, moduli },
    UsualRange { "E2_GPa", 1e-3, 1500, moduli },
    UsualRange { "G12_GPa", 1e-4, 800, moduli },
    UsualRange { "shear_modulus_MPa", 1e-3, 5e4, { { { "Pa", 1e-6 }, { "kPa", 1e-3 }, { "GPa", 1e3 } } } },
    UsualRange { "density_kg_m3", 20, 25000, { { { "g/cm^3", 1e3 }, { "g/m^3", 1e-3 }, { "mg/m^3", 1e-6 } } } },
    UsualRange { "d31_m_per_V", 1e-13, 5e-9, { { { "pm/V (pC/N)", 1e-12 }, { "nm/V", 1e-9 }, { "um/V", 1e-6 } } } },
    UsualRange { "d32_m_per_V", 1e-13, 5e-9, { { { "pm/V (pC/N)", 1e-12 }, { "nm/V", 1e-9 }, { "um/V", 1e-6 } } } },
    UsualRange { "damping_ratio", 1e-6, 0.3, { { { "%", 0.01 }, { "per mille", 1e-3 }, { "ppm", 1e-6 } } } },
    UsualRange { "voltage_V", 0.5, 5000, { { { "kV", 1e3 }, { "mV", 1e-3 }, { "uV", 1e-6 } } } },
    UsualRange { "full_scale_V", 0.5, 5000, { { { "kV", 1e3 }, { "mV", 1e-3 }, { "uV", 1e-6 } } } },
    UsualRange { "slew_V_per_us", 1e-3, 1e4, { { { "V/s", 1e-6 }, { "V/ms", 1e-3 }, { "kV/us", 1e3 } } } },
    UsualRange { "current_mA", 0.05, 1e5, { { { "A", 1e3 }, { "uA", 1e-3 }, { "nA", 1e-6 } } } },
    UsualRange { "capacitance_nF", 0.01, 1e5, { { { "uF", 1e3 }, { "pF", 1e-3 }, { "F", 1e9 } } } },
    UsualRange { "maximum_frequency_Hz", 50, 1e6, { { { "kHz", 1e3 }, { "MHz", 1e6 }, { "mHz", 1e-3 } } } },
};

bool isUsual (const UsualRange& range, double value)
{
    return value == 0 || (std::abs (value) >= range.least && std::abs (value) <= range.most);
}

void addIfUnlikely (std::vector<std::string>& sentences, const UsualRange& range, const std::string& place,
                    double value)
{
    if (isUsual (range, value))
        return;

    for (const auto& unit : range.units)
        if (isUsual (range, unit.factor * value))
        {
            sentences.push_back (place + " is " + numberText (value)
                                 + ", which hardly any device has: if it was meant in " + std::string (unit.name)
                                 + ", write " + formatted ("%.6g", unit.factor * value) + ".");
            return;
        }
}

/** @param place  as a JSON pointer
    @param path   the same without indices */
void visit (std::vector<std::string>& sentences, const nlohmann::json& value, const std::string& place,
            const std::string& path)
{
    if (value.is_number())
    {
        const auto isKey = [&] (const UsualRange& range) { return path.ends_with ("/" + std::string (range.key)); };

        if (const auto* const range = std::find_if (usualRanges.begin(), usualRanges.end(), isKey);
            range != usualRanges.end())
            addIfUnlikely (sentences, *range, place, value.get<double>());
    }

    if (value.is_structured())
        for (const auto& [name, item] : value.items())
        {
            const auto step = std::string ("/").append (name);
            visit (sentences, item, std::string (place).append (step),
                   value.is_array() ? path : std::string (path).append (step));
        }
}
} // namespace

std::vector<std::string> unlikelyValues (const nlohmann::json& document)
{
    std::vector<std::string> sentences;
    visit (sentences, document, {}, {});
    return sentences;
}
} // namespace antinode
