#include "CeramicLag.h"
#include "CompactShapes.h"
#include "DeviceFile.h"
#include "FileUnits.h"
#include "ModalBoundary.h"
#include "OriginReader.h"
#include "OutlineReader.h"

#include <antinode_text/EigenJson.h>

#include <algorithm>
#include <vector>

namespace antinode
{
namespace
{
using Json = nlohmann::ordered_json;

double largestLimit (const ModalModel& model)
{
    double largest = 0;

    for (const auto& ceramic : model.ceramics)
        largest = std::max (largest, ceramic.voltageLimit);

    return largest > 0 ? largest : model.fullScaleVoltage;
}

/** What the ceramics and amplifiers of a device may do, as its file says it, or as its ceramics do. */
Json limitsOf (const ModalModel& model, const Json& given)
{
    auto limits = given.is_object() ? given : Json { { "voltage_V", largestLimit (model) } };
    limits["full_scale_V"] = model.fullScaleVoltage;
    limits.erase ("current_mA"); // Its ceramics have the slew limits that follow from it.
    return limits;
}

/** A shape or slope: numbers that people can read, or compact where they would fill a file. */
Json shapeToJson (const ModalModel& model, const Eigen::VectorXd& shape)
{
    constexpr Eigen::Index mostNumbers = 100000; // as text
    return model.shapes.size() > mostNumbers ? Json (compactNumbers (shape)) : toJsonList (shape);
}

/** Behind the real parts, which are as those of real modes. */
void addImaginaryParts (Json& mode, const ModalModel& model, Eigen::Index k)
{
    const auto imaginary = model.modes() + k;
    mode["participation_imaginary_per_V"] = toJsonList (model.participation.row (imaginary));
    mode["shape_imaginary"] = shapeToJson (model, model.shapes.col (imaginary));

    if (model.slopes.size() > 0)
        mode["slope_imaginary"] = shapeToJson (model, model.slopes.col (imaginary));
}

Json modesToJson (const ModalModel& model)
{
    auto modes = Json::array();

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        Json mode;
        mode["frequency_Hz"] = toHertz (model.angularFrequencies[k]);
        mode["damping_ratio"] = model.dampingRatios[k];

        if (model.frequencyErrors.size() > 0)
            mode["frequency_error_relative"] = model.frequencyErrors[k];

        mode["participation_per_V"] = toJsonList (model.participation.row (k));
        mode["shape"] = shapeToJson (model, model.shapes.col (k));

        if (model.slopes.size() > 0)
            mode["slope"] = shapeToJson (model, model.slopes.col (k));

        if (model.hasComplexModes())
            addImaginaryParts (mode, model, k);

        modes.push_back (std::move (mode));
    }

    return modes;
}

Json ceramicsToJson (const ModalModel& model, const Json& limits)
{
    auto ceramics = Json::array();
    const auto limit = limits["voltage_V"].get<double>();
    const auto slew = fromVoltsPerMicrosecond (limits.value ("slew_V_per_us", 0.0));

    for (const auto& ceramic : model.ceramics)
    {
        const auto x = toMillimetres (ceramic.xMinimum), y = toMillimetres (ceramic.yMinimum);
        Json item { { "name", ceramic.name },
                    { "x_mm", x },
                    { "y_mm", y },
                    { "size_x_mm", toMillimetres (ceramic.xMaximum) - x },
                    { "size_y_mm", toMillimetres (ceramic.yMaximum) - y } };

        if (ceramic.voltageLimit != limit)
            item["voltage_limit_V"] = ceramic.voltageLimit;

        if (ceramic.slewLimit != slew)
            item["slew_limit_V_per_us"] = toVoltsPerMicrosecond (ceramic.slewLimit);

        if (ceramic.capacitance > 0)
            item["capacitance_nF"] = toNanofarads (ceramic.capacitance);

        if (ceramic.capacitance > 0 || ceramic.lossFactor != usualLossFactor)
            item["loss_factor"] = ceramic.lossFactor;

        if (ceramic.lag != InputLag {})
            item["lag"] = lagToJson (ceramic.lag);

        if (! ceramic.outline.paths.empty())
            item["outline"] = outlineToJson (ceramic.outline);

        ceramics.push_back (std::move (item));
    }

    return ceramics;
}

/** Without a grid values beyond the boundary mean nothing: points that only carried it are left out. */
ModalModel withoutGrid (ModalModel model)
{
    const auto& surface = model.surface;

    if (! surface.boundary || ! surface.grid)
        return model;

    std::vector<Eigen::Index> kept;

    for (Eigen::Index p = 0; p < model.points(); ++p)
        if (surface.areas[p] > 0 || surface.masses[p] > 0)
            kept.push_back (p);

    return onPoints (std::move (model), kept);
}

/** What the units of the other keys cannot express to the last bit. */
Json exactToJson (const ModalModel& model)
{
    const auto& surface = model.surface;
    auto extents = Json::array();

    for (const auto& ceramic : model.ceramics)
        extents.push_back ({ ceramic.xMinimum, ceramic.xMaximum, ceramic.yMinimum, ceramic.yMaximum });

    return { { "angular_frequencies_rad_s", toJsonList (model.angularFrequencies) },
             { "points_m", toJsonRows (surface.points) },
             { "extent_m", { surface.xMinimum, surface.xMaximum, surface.yMinimum, surface.yMaximum } },
             { "ceramic_extents_m", std::move (extents) } };
}
} // namespace

nlohmann::ordered_json modalDeviceToJson (const ModalModel& given, const std::string& description,
                                          const nlohmann::ordered_json& givenLimits)
{
    const auto model = withoutGrid (given);
    Json device { { "schema", "antinode.device/1" }, { "name", model.name } };

    if (! description.empty())
        device["description"] = description;

    auto points = Json::array();

    for (Eigen::Index p = 0; p < model.points(); ++p)
        points.push_back ({ toMillimetres (model.surface.points (p, 0)), toMillimetres (model.surface.points (p, 1)) });

    device["kind"] = "modal";
    device["limits"] = limitsOf (model, givenLimits);
    device["ceramics"] = ceramicsToJson (model, device["limits"]);

    if (model.origin != ModeOrigin {})
        device[originKey] = originToJson (model.origin);

    device["rigid_body_modes"] = model.rigidBodyModes;
    device["covers_whole_body"] = model.coversWholeBody;
    device["modes"] = modesToJson (model);
    device["points_mm"] = std::move (points);

    for (Eigen::Index i = 0; i < model.staticShare.cols(); ++i)
        device["static_share_m_per_V"].push_back (shapeToJson (model, model.staticShare.col (i)));

    device["weights_kg"] = toJsonList (model.surface.masses);
    device["areas_m2"] = toJsonList (model.surface.areas);

    if (model.surface.boundary)
        boundaryToJson (device, *model.surface.boundary);

    device["exact"] = exactToJson (model);
    return device;
}
} // namespace antinode
