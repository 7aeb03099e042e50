#include "ModalFile.h"

#include "DeviceFile.h"
#include "FileUnits.h"
#include "ModalSurface.h"
#include "OutlineReader.h"
#include "SharedFields.h"

#include <antinode_base/MessageText.h>
#include <antinode_text/JsonReader.h>
#include <antinode_text/JsonText.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <vector>

namespace antinode
{
namespace
{
constexpr NumberRange anyNumber { -1e12, 1e12 };
constexpr NumberRange notNegative { 0, 1e12 };
constexpr NumberRange ceramicSizeMillimetre { 0, 1e5 };
constexpr double largestGramError = 0.02; ///< Above it the points do not represent the whole body.

Eigen::VectorXd readVector (const JsonValue& list, Eigen::Index size, const NumberRange& range)
{
    const auto count = static_cast<std::size_t> (size);
    const auto numbers = list.numbers (count, count, range);
    return Eigen::Map<const Eigen::VectorXd> (numbers.data(), size);
}

/** A shape of so many points: a list of numbers, or the same compact. */
Eigen::VectorXd readShape (const JsonValue& shape, Eigen::Index points)
{
    return shape.isString() ? readCompactNumbers (shape, points) : readVector (shape, points, anyNumber);
}

/** Whether an optional key is given. @throws InputError  when some modes have it and others do not */
bool allHave (const std::vector<JsonObject>& modes, std::string_view key)
{
    const auto has = [&] (const auto& mode) { return mode.has (key); };
    const auto lacking = std::find_if_not (modes.begin(), modes.end(), has);

    if (lacking != modes.end() && std::any_of (modes.begin(), modes.end(), has))
        lacking->fail ("has no " + inQuotes (key) + "; allowed: for all modes or none");

    return lacking == modes.end();
}

std::vector<JsonObject> readModeList (const JsonObject& device)
{
    std::vector<JsonObject> modes;

    for (const auto& mode : device.required ("modes").items (1, ranges::maximumModes))
        modes.push_back (
            mode.object ({ "frequency_Hz", "damping_ratio", "quality_factor", "participation_per_V",
                           "participation_imaginary_per_V", "shape", "shape_imaginary", "slope", "slope_imaginary",
                           "frequency_error_relative", "frequency_standard_deviation_Hz",
                           "damping_ratio_standard_deviation", "participation_standard_deviation_per_V" }));

    return modes;
}

/** The imaginary parts of a complex mode, which lie behind the real parts of all modes. */
void readImaginaryParts (const JsonObject& mode, const std::vector<Eigen::Index>& order, Eigen::Index k,
                         ModalModel& model)
{
    const auto points = model.points(), imaginary = model.modes() + k;
    model.participation.row (imaginary) =
        readVector (mode.required ("participation_imaginary_per_V"), model.actuators(), anyNumber);
    model.shapes.col (imaginary) = readShape (mode.required ("shape_imaginary"), points) (order);

    if (model.slopes.rows() > 0)
        model.slopes.col (imaginary) = readShape (mode.required ("slope_imaginary"), points) (order);
}

/** One mode. The model has its sizes already. */
void readMode (const JsonObject& mode, const std::vector<Eigen::Index>& order, Eigen::Index k, ModalModel& model)
{
    const auto points = model.points();
    model.angularFrequencies[k] = fromHertz (mode.required ("frequency_Hz").number (ranges::frequencyHz));
    model.dampingRatios[k] = readDampingRatio (mode);
    model.participation.row (k) = readVector (mode.required ("participation_per_V"), model.actuators(), anyNumber);
    model.shapes.col (k) = readShape (mode.required ("shape"), points) (order);

    if (model.slopes.rows() > 0)
        model.slopes.col (k) = readShape (mode.required ("slope"), points) (order);

    if (model.hasComplexModes())
        readImaginaryParts (mode, order, k, model);

    if (model.frequencyErrors.size() > 0)
        model.frequencyErrors[k] = mode.required ("frequency_error_relative").number (notNegative);

    for (const auto* const key : { "frequency_standard_deviation_Hz", "damping_ratio_standard_deviation" })
        if (const auto deviation = mode.optional (key))
            deviation->number (notNegative);

    if (const auto deviations = mode.optional ("participation_standard_deviation_per_V"))
        readVector (*deviations, model.actuators(), notNegative);
}

/** Whether modes have imaginary parts. @throws InputError  when some have, or they are not whole */
bool areComplex (const std::vector<JsonObject>& modes, bool haveSlopes)
{
    const auto haveShapes = allHave (modes, "shape_imaginary");
    const auto haveParticipations = allHave (modes, "participation_imaginary_per_V");
    const auto haveImaginarySlopes = allHave (modes, "slope_imaginary");

    if (haveShapes != haveParticipations)
        modes.front().fail ("has an imaginary part of its shape or of its participation only; allowed: both or none");

    if (haveImaginarySlopes != (haveShapes && haveSlopes))
        modes.front().fail ("has 'slope_imaginary' without 'slope' and 'shape_imaginary', or lacks it; allowed: the "
                            "imaginary part of every quantity or of none");

    return haveShapes;
}

void readModes (const JsonObject& device, const std::vector<Eigen::Index>& order, ModalModel& model)
{
    const auto modes = readModeList (device);
    const auto modeCount = static_cast<Eigen::Index> (modes.size());
    const auto points = model.surface.points.rows();
    const auto hasSlopes = allHave (modes, "slope");

    if (hasSlopes && model.surface.kind == SurfaceKind::plate)
        modes.front().required ("slope").fail (
            "is given for a plate; allowed only on a line (all points with the same y)");

    // The first mode says how many ceramics there are; the others must agree.
    const auto ceramics = modes.front().required ("participation_per_V").items (0, ranges::maximumCeramics).size();
    const auto coordinates = areComplex (modes, hasSlopes) ? 2 * modeCount : modeCount;
    model.angularFrequencies.resize (modeCount);
    model.dampingRatios.resize (modeCount);
    model.shapes.resize (points, coordinates);
    model.slopes.resize (hasSlopes ? points : 0, hasSlopes ? coordinates : 0);
    model.participation.resize (coordinates, static_cast<Eigen::Index> (ceramics));
    model.frequencyErrors.resize (allHave (modes, "frequency_error_relative") ? modeCount : 0);

    for (Eigen::Index k = 0; k < modeCount; ++k)
        readMode (modes[static_cast<std::size_t> (k)], order, k, model);
}

/** What modes beyond do: one list per ceramic. */
void readStaticShare (const JsonValue& lists, const std::vector<Eigen::Index>& order, ModalModel& model)
{
    if (model.hasComplexModes())
        lists.fail ("is given with complex modes; allowed: with real ones");

    const auto ceramics = static_cast<std::size_t> (model.actuators());
    model.staticShare.resize (model.points(), model.actuators());
    Eigen::Index i = 0;

    for (const auto& list : lists.items (ceramics, ceramics))
        model.staticShare.col (i++) = readShape (list, model.points()) (order);
}

Ceramic readCeramic (const JsonValue& value, const VoltageLimits& limits)
{
    const auto object = value.object ({ "name", "x_mm", "y_mm", "size_x_mm", "size_y_mm", "voltage_limit_V",
                                        "slew_limit_V_per_us", "capacitance_nF", "loss_factor", "lag", "outline" });
    const auto x = object.required ("x_mm").number (ranges::positionMillimetre);
    const auto y = object.required ("y_mm").number (ranges::positionMillimetre);
    const auto name = object.optional ("name");
    const auto ownLimit = object.optional ("voltage_limit_V");
    const auto ownSlew = object.optional ("slew_limit_V_per_us");
    const auto capacitance = object.optional ("capacitance_nF");
    const auto loss = object.optional ("loss_factor");

    Ceramic ceramic;
    ceramic.name = name ? name->text (ranges::maximumNameBytes) : "";
    ceramic.xMinimum = fromMillimetres (x);
    ceramic.xMaximum = fromMillimetres (x + object.required ("size_x_mm").number (ceramicSizeMillimetre));
    ceramic.yMinimum = fromMillimetres (y);
    ceramic.yMaximum = fromMillimetres (y + object.required ("size_y_mm").number (ceramicSizeMillimetre));
    ceramic.voltageLimit = ownLimit ? ownLimit->number ({ 0, limits.voltage }) : limits.voltage;
    ceramic.slewLimit =
        ownSlew ? fromVoltsPerMicrosecond (ownSlew->number (ranges::slewVoltsPerMicrosecond)) : limits.slew;
    ceramic.capacitance = capacitance ? fromNanofarads (capacitance->number (ranges::capacitanceNanofarad)) : 0.0;
    ceramic.lossFactor = loss ? loss->number (ranges::lossFactor) : usualLossFactor;

    if (const auto lag = object.optional ("lag"))
        ceramic.lag = readLag (*lag);

    ceramic.area = (ceramic.xMaximum - ceramic.xMinimum) * (ceramic.yMaximum - ceramic.yMinimum);

    if (const auto outline = object.optional ("outline"))
    {
        ceramic.outline = readOutline (*outline).outline;
        ceramic.area = areaOf (ceramic.outline);
    }

    return ceramic;
}

/** The ceramics, of which a modal device may say nothing but their number and limit. */
void readCeramics (const JsonObject& device, ModalModel& model)
{
    const auto limitsObject = device.required ("limits");
    const auto limits = readLimits (limitsObject);

    if (limits.current > 0)
        limitsObject.fail (
            "has 'current_mA', which needs the capacitance of the ceramics, unknown for a modal device; allowed: "
            "'slew_V_per_us', the current divided by the capacitance");

    const auto count = static_cast<std::size_t> (model.actuators());
    model.fullScaleVoltage = limits.fullScale;
    model.ceramics.resize (count, { {}, 0, 0, 0, 0, limits.voltage, limits.slew });

    if (const auto list = device.optional ("ceramics"))
    {
        const auto items = list->items (count, count);
        std::transform (items.begin(), items.end(), model.ceramics.begin(),
                        [&] (const auto& item) { return readCeramic (item, limits); });
    }

    for (std::size_t i = 0; i < count; ++i)
        if (model.ceramics[i].name.empty())
            model.ceramics[i].name = "C" + std::to_string (i + 1);
}

void refineFromExact (const JsonObject& exact, ModalModel& model)
{
    const auto modes = static_cast<std::size_t> (model.modes());
    const auto frequencies = exact.required ("angular_frequencies_rad_s").items (modes, modes);
    const auto extents = exact.required ("ceramic_extents_m").items (model.ceramics.size(), model.ceramics.size());

    for (std::size_t k = 0; k < modes; ++k)
    {
        auto& frequency = model.angularFrequencies[static_cast<Eigen::Index> (k)];
        frequency = refined (frequency, frequencies[k]);
    }

    for (std::size_t i = 0; i < extents.size(); ++i)
    {
        const auto extent = extents[i].items (4, 4);
        auto& ceramic = model.ceramics[i];
        ceramic.xMinimum = refined (ceramic.xMinimum, extent[0]);
        ceramic.xMaximum = refined (ceramic.xMaximum, extent[1]);
        ceramic.yMinimum = refined (ceramic.yMinimum, extent[2]);
        ceramic.yMaximum = refined (ceramic.yMaximum, extent[3]);
    }
}

void sortModes (ModalModel& model)
{
    std::vector<Eigen::Index> order (static_cast<std::size_t> (model.modes()));
    std::iota (order.begin(), order.end(), Eigen::Index { 0 });
    std::stable_sort (order.begin(), order.end(),
                      [&] (auto a, auto b) { return model.angularFrequencies[a] < model.angularFrequencies[b]; });
    model.angularFrequencies = model.angularFrequencies (order).eval();
    model.dampingRatios = model.dampingRatios (order).eval();
    auto coordinates = order;

    if (model.hasComplexModes())
        std::transform (order.begin(), order.end(), std::back_inserter (coordinates),
                        [&] (auto k) { return model.modes() + k; });

    model.shapes = model.shapes (Eigen::all, coordinates).eval();
    model.participation = model.participation (coordinates, Eigen::all).eval();

    if (model.slopes.size() > 0)
        model.slopes = model.slopes (Eigen::all, coordinates).eval();

    if (model.frequencyErrors.size() > 0)
        model.frequencyErrors = model.frequencyErrors (order).eval();
}

/** True if sum w phi_k phi_l is the identity: the points then represent the whole body. */
bool shapesAreOrthonormal (const ModalModel& model)
{
    const Eigen::MatrixXd gram = model.shapes.transpose() * model.surface.masses.asDiagonal() * model.shapes;
    return (gram - Eigen::MatrixXd::Identity (model.modes(), model.modes())).cwiseAbs().maxCoeff() <= largestGramError;
}
} // namespace

ModalModel readModalModel (const JsonValue& device)
{
    const auto body =
        device.object ({ "schema", "name", "description", "kind", "modes", "points_mm", "weights_kg", "areas_m2",
                         "ceramics", "limits", "delay_s", "delay_standard_deviation_s", "covers_whole_body",
                         "rigid_body_modes", "outline", "held_edges", "exact", "static_share_m_per_V", originKey });
    std::optional<JsonObject> exact;

    if (const auto given = body.optional ("exact"))
        exact = given->object ({ "angular_frequencies_rad_s", "points_m", "extent_m", "ceramic_extents_m" });

    ModalModel model;
    const auto given = readSurface (body, exact);
    model.surface = given.surface;
    readBoundary (body, model.surface);
    readModes (body, given.order, model);
    readCeramics (body, model);

    if (const auto share = body.optional ("static_share_m_per_V"))
        readStaticShare (*share, given.order, model);

    if (exact)
        refineFromExact (*exact, model);

    if (const auto delay = body.optional ("delay_s"))
        delay->number ({ -1, 1 });

    if (const auto deviation = body.optional ("delay_standard_deviation_s"))
        deviation->number (notNegative);

    if (const auto rigid = body.optional ("rigid_body_modes"))
        model.rigidBodyModes = rigid->integer (0, 6);

    if (const auto origin = body.optional (originKey))
        model.origin = readOrigin (*origin);

    sortModes (model);
    const auto covers = body.optional ("covers_whole_body");

    if (covers && covers->boolean() && model.hasComplexModes())
        covers->fail ("is true, but shapes of complex modes are not orthogonal; allowed: false");

    model.coversWholeBody = ! model.hasComplexModes() && (covers ? covers->boolean() : shapesAreOrthonormal (model));
    const auto needsSlopes = model.surface.kind == SurfaceKind::line && model.slopes.size() == 0;
    return needsSlopes ? withSplineSlopes (std::move (model)) : model;
}

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
