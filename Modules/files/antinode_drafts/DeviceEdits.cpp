#include "DeviceEdits.h"

#include "CeramicEdits.h"

#include <antinode_documents/OutlineReader.h>
#include <antinode_outline/PathBuilder.h>
#include <antinode_text/JsonReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
using nlohmann::json;

constexpr double metre = 1000; // mm

std::string kindOf (const json& device)
{
    return device.value ("kind", "");
}

std::string shapeOf (const json& device)
{
    return device.contains ("outline") ? device["outline"].value ("shape", "") : std::string();
}

/** The keys of both sides, where each can be chosen. */
std::array<std::string, 2> sizeKeys (const json& device)
{
    if (kindOf (device) == "staple")
        return { "top_length_mm", "width_mm" };

    if (kindOf (device) == "beam")
        return { "length_mm", "width_mm" };

    if (device.contains ("outline"))
        return { "size_x_mm", "size_y_mm" };

    return { "length_x_mm", "length_y_mm" };
}

const json& ownerOfSize (const json& device)
{
    return device.contains ("outline") ? device["outline"] : device;
}

/** All lengths and places in an outline larger by a factor along each axis; of what has no direction, as radii, by
    the smaller one. */
void scaleLengths (json& value, const Eigen::Vector2d& factor)
{
    const auto least = factor.minCoeff();

    for (auto& [key, item] : value.items())
    {
        const auto isLength = key.ends_with ("_mm");

        if (isLength && item.is_number())
            item = tidy (item.get<double>()
                         * (key.find ("_x_") != std::string::npos   ? factor.x()
                            : key.find ("_y_") != std::string::npos ? factor.y()
                                                                    : least));
        else if (key == "vertices_mm")
            for (auto& place : item)
                place = placeJson (placeOf (place).cwiseProduct (factor));
        else if (isLength && key != "radius_mm" && item.is_array() && item.size() == 2)
            item = placeJson (placeOf (item).cwiseProduct (factor));
        else if (isLength && item.is_array())
            for (auto& number : item)
                number = tidy (number.get<double>() * least);
        else if (item.is_structured())
            scaleLengths (item, factor);
    }
}

/** Places of the list of a key, which are given by two numbers. */
void scalePlaces (json& device, const char* key, const Eigen::Vector2d& factor)
{
    if (device.contains (key))
        for (auto& item : device[key])
        {
            item["x_mm"] = tidy (item["x_mm"].get<double>() * factor.x());
            item["y_mm"] = tidy (item["y_mm"].get<double>() * factor.y());
        }
}
} // namespace

bool isDrawn (const json& device)
{
    return device.contains ("kind") && kindOf (device) != "modal";
}

bool isLine (const json& device)
{
    return kindOf (device) == "beam" || kindOf (device) == "staple";
}

json withName (json device, const std::string& name)
{
    device["name"] = name;
    return device;
}

bool hasTwoSizes (const json& device)
{
    return shapeOf (device).empty() || shapeOf (device) == "rectangle" || shapeOf (device) == "ellipse";
}

Eigen::Vector2d sizeOf (const json& device)
{
    if (! hasTwoSizes (device))
        return extentOf (outlineOf (device)).size() * metre;

    const auto& owner = ownerOfSize (device);
    const auto keys = sizeKeys (device);
    return { owner[keys[0]].get<double>(), owner[keys[1]].get<double>() };
}

json withSize (json device, const Eigen::Vector2d& size)
{
    const auto before = sizeOf (device);
    Eigen::Vector2d factor = size.cwiseQuotient (before);

    if (! hasTwoSizes (device))
        factor.y() = factor.x();

    if (device.contains ("outline"))
        scaleLengths (device["outline"], factor);
    else
        for (const auto i : { 0, 1 })
            device[sizeKeys (device)[static_cast<std::size_t> (i)]] = tidy (size[i]);

    if (isLine (device))
        factor.y() = 1;

    auto ceramics = ceramicsOf (device);

    for (std::size_t i = 0; i < ceramics.size(); ++i)
    {
        ceramics[i].centre = ceramics[i].centre.cwiseProduct (factor);
        device = withCeramic (std::move (device), i, ceramics[i]);
    }

    scalePlaces (device, "points", factor);

    if (device.contains ("areas"))
        for (auto& area : device["areas"])
            scaleLengths (area["outline"], factor);

    if (device.contains ("edges") && device["edges"].is_object() && device["edges"].contains ("parts"))
        scaleLengths (device["edges"]["parts"], factor);

    return device;
}

std::vector<DrawnLayer> layersOf (const json& device)
{
    std::vector<DrawnLayer> layers;

    if (! device.contains ("layers"))
        return { { device["material"], device["thickness_mm"].get<double>() } };

    for (const auto& layer : device["layers"])
        layers.push_back ({ layer["material"], layer["thickness_mm"].get<double>() });

    return layers;
}

json withLayers (json device, const std::vector<DrawnLayer>& layers)
{
    device.erase ("layers");
    device.erase ("material");
    device.erase ("thickness_mm");

    if (layers.size() == 1)
    {
        device["material"] = layers.front().material;
        device["thickness_mm"] = layers.front().thickness;
        return device;
    }

    for (const auto& [material, thickness] : layers)
        device["layers"].push_back ({ { "material", material }, { "thickness_mm", thickness } });

    return device;
}

double qualityFactorOf (const json& device)
{
    const auto first = [] (const json& value) { return (value.is_array() ? value.at (0) : value).get<double>(); };

    if (device.contains ("quality_factor"))
        return first (device["quality_factor"]);

    return device.contains ("damping_ratio") ? 0.5 / first (device["damping_ratio"]) : 0;
}

json withQualityFactor (json device, double qualityFactor)
{
    device.erase ("damping_ratio");
    device["quality_factor"] = qualityFactor;
    return device;
}

double voltageLimitOf (const json& device)
{
    return device["limits"]["voltage_V"].get<double>();
}

json withVoltageLimit (json device, double volts)
{
    auto& limits = device["limits"];
    limits["voltage_V"] = volts;

    if (limits.contains ("full_scale_V"))
        limits["full_scale_V"] = std::max (volts, limits["full_scale_V"].get<double>());

    return device;
}

namespace
{
/** The middle of a line at the origin, of a plate the lower left corner. */
Outline rectangleOf (const json& device)
{
    const Eigen::Vector2d size = sizeOf (device) / metre;
    const Eigen::Vector2d centre = isLine (device) ? Eigen::Vector2d::Zero().eval() : (size / 2).eval();
    return { { rectanglePath (centre, size, 0, { 0, 0, 0, 0 }, 0) } };
}

NamedOutline namedOutline (const json& device)
{
    if (device.contains ("outline"))
        return readOutline (JsonValue (device, "device").required ("outline"));

    return { rectangleOf (device), { "bottom", "right", "top", "left" } };
}
} // namespace

Outline outlineOf (const json& device)
{
    return namedOutline (device).outline;
}

std::vector<DrawnEdge> edgesOf (const json& device)
{
    if (kindOf (device) == "staple")
        return {};

    const auto named = namedOutline (device);
    std::vector<DrawnEdge> edges;

    for (const auto& name : named.edges)
        edges.push_back ({ name, {} });

    for (const auto& path : named.outline.paths)
        for (const auto& piece : path)
            edges[static_cast<std::size_t> (piece.edge)].pieces.push_back (piece);

    if (isLine (device))
        std::erase_if (edges, [] (const auto& edge) { return edge.name == "bottom" || edge.name == "top"; });

    return edges;
}

json withOutline (json device, json outline)
{
    const auto edges = edgesOf (device);
    const auto support = edges.empty() ? json ("free") : supportOf (device, edges.front().name);

    for (const auto* const key : { "length_x_mm", "length_y_mm" })
        device.erase (key);

    device["kind"] = "plate";
    device["outline"] = std::move (outline);
    device["edges"] = support;
    return device;
}

const std::vector<UsualSupport>& usualSupports()
{
    static const std::vector<UsualSupport> all { { "free", "free", 0, 0, 0, true },
                                                 { "supported", "simply_supported", 0, 0, 0, true },
                                                 { "clamped", "clamped", 0, 0, 0, true },
                                                 { "guided", "guided", 0, 0, 0, true, false },
                                                 { "foam tape", "", 10, 5, 0.5 },
                                                 { "soft foam", "", 0.5, 2, 0.3 },
                                                 { "silicone", "", 3, 3, 0.1 } };
    return all;
}

json supportJson (const UsualSupport& support, double stiffness)
{
    if (! support.word.empty())
        return support.word;

    const auto translation = stiffness > 0 ? stiffness : support.stiffness;
    return { { "stiffness_N_per_mm2", translation },
             { "rotation_stiffness_N", tidy (translation * support.width * support.width / 12) },
             { "loss_factor", support.lossFactor } };
}

const UsualSupport* usualSupport (const json& support)
{
    for (const auto& usual : usualSupports())
    {
        const auto stiffness = support.is_object() ? support.value ("stiffness_N_per_mm2", 0.0) : 0.0;

        if (support.is_object() ? usual.word.empty() && support == supportJson (usual, stiffness)
                                : support == json (usual.word))
            return &usual;
    }

    return nullptr;
}

namespace
{
/** Where a device says how its edges are held. */
const char* edgesKey (const json& device)
{
    return isLine (device) ? "ends" : "edges";
}

bool isOfAll (const json& edges)
{
    return ! edges.is_object() || edges.contains ("stiffness_N_per_mm2") || edges.contains ("rotation_stiffness_N");
}
} // namespace

json supportOf (const json& device, const std::string& edge)
{
    const auto& edges = device[edgesKey (device)];

    if (isOfAll (edges))
        return edges;

    return edges.contains (edge) ? edges[edge] : edges.value ("others", json());
}

json withSupport (json device, const std::string& edge, const json& support)
{
    auto& edges = device[edgesKey (device)];
    const auto isOutlined = device.contains ("outline");

    if (isOutlined && edge.empty())
    {
        auto kept = ! isOfAll (edges) && edges.contains ("parts") ? edges["parts"] : json();
        edges = support;

        if (! kept.is_null())
            edges = { { "others", support }, { "parts", std::move (kept) } };

        return device;
    }

    if (isOutlined && isOfAll (edges))
        edges = { { "others", edges } };

    if (edge.empty())
        for (const auto& each : edgesOf (device))
            edges[each.name] = support;
    else
        edges[edge] = support;

    return device;
}
} // namespace antinode
