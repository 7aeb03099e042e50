#include "UniversalResponses.h"

#include "CsvResponses.h"
#include "UniversalRecords.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <string_view>
#include <tuple>

namespace antinode
{
namespace
{
constexpr int timeRecord = 1, frequencyResponse = 4;

using Functions = std::vector<const UniversalFunction*>;

template <typename Set>
std::vector<const Set*> findSets (const std::vector<UniversalSet>& sets)
{
    std::vector<const Set*> found;

    for (const auto& set : sets)
        if (const auto* const one = std::get_if<Set> (&set))
            found.push_back (one);

    return found;
}

Functions findFunctions (const std::vector<UniversalSet>& sets, int type)
{
    auto functions = findSets<UniversalFunction> (sets);
    std::erase_if (functions, [&] (const auto* function)
                   { return function->functionType != type || function->values.size() < 2; });
    return functions;
}

bool isNamed (const std::string& entity)
{
    return ! entity.empty() && entity != "NONE";
}

/** How points are called: by their node; by entity and node where several entities number their own; by the entity
   alone where there is no number. */
class PlaceNames
{
public:
    PlaceNames (const Functions& functions, UniversalPlace UniversalFunction::*member)
    {
        std::map<UniversalLabel, std::string> entities;

        for (const auto* function : functions)
        {
            const auto& place = function->*member;
            const auto [known, isNew] = entities.emplace (place.node, place.entity);
            areAmbiguous = areAmbiguous || (! isNew && known->second != place.entity);
        }
    }

    std::string of (const UniversalPlace& place) const
    {
        if (place.node == 0)
            return isNamed (place.entity) ? place.entity : "";

        const auto number = std::to_string (place.node);
        return areAmbiguous && isNamed (place.entity) ? place.entity + ":" + number : number;
    }

private:
    bool areAmbiguous = false;
};

/** The axis, 1 to 3, along which most responses are measured; of equally many that along which forces act, else the
    last one, z: a triaxial sensor has all three. 0 if unknown. */
int commonAxis (const Functions& functions)
{
    std::map<int, int> counts, drives;

    for (const auto* function : functions)
    {
        ++counts[std::abs (function->response.direction)];
        ++drives[std::abs (function->reference.direction)];
    }

    return std::max_element (counts.begin(), counts.end(),
                             [&drives] (const auto& a, const auto& b) {
                                 return std::tuple (a.second, drives[a.first], a.first)
                                        < std::tuple (b.second, drives[b.first], b.first);
                             })
        ->first;
}

constexpr std::string_view windowWords = "Exponential window, 1/s: ";

/** What a line of a function says of an exponential window; 0 where none does. */
double findWindowDecay (const UniversalFunction& function)
{
    for (const auto& line : function.lines)
        if (line.starts_with (windowWords))
        {
            double decay = 0;
            const auto digits = std::string_view (line).substr (windowWords.size());
            const auto [end, error] = std::from_chars (digits.data(), digits.data() + digits.size(), decay);

            if (error == std::errc() && std::isfinite (decay) && decay > 0)
                return decay;
        }

    return 0;
}

std::optional<ResponseUnit> unitOfCode (int quantity, const UniversalUnits& units)
{
    constexpr int displacement = 8, reaction = 9, velocity = 11, acceleration = 12, force = 13;

    switch (quantity)
    {
        case displacement:
            return ResponseUnit { ResponseQuantity::displacement, 1 / units.length, {} };
        case velocity:
            return ResponseUnit { ResponseQuantity::velocity, 1 / units.length, {} };
        case acceleration:
            return ResponseUnit { ResponseQuantity::acceleration, 1 / units.length, {} };
        case reaction:
        case force:
            return ResponseUnit { {}, 1 / units.force, DriveQuantity::force };
        default:
            return std::nullopt;
    }
}

/** What a function's numbers mean: by the units that its axes name, else by the codes of their quantities in the file's
    units. */
ResponseUnit findUnit (const UniversalFunction& function, const UniversalUnits& units)
{
    auto motion = universalUnit (function.ordinate, units);
    auto drive = driveUnit (function.denominator.unit);

    if (! motion)
        motion = quantityWord (function.ordinate.label);

    if (! motion || motion->drive)
        return motion.value_or (ResponseUnit {});

    if (! drive)
        drive = unitOfCode (function.denominator.quantity, units);

    if (drive && drive->drive)
        return { motion->quantity, motion->factor / drive->factor, drive->drive };

    return *motion;
}

/** Names the units of axes that are not known. A motion may have the unit of a motion per drive. */
void addUnknownUnits (const Functions& functions, const std::string& source, std::vector<std::string>& remarks)
{
    std::set<std::string> labels;

    for (const auto* function : functions)
    {
        const auto &motion = function->ordinate.unit, &drive = function->denominator.unit;

        if (! responseUnit (motion) && (driveUnit (motion) || isUnknownUnit (motion)))
            labels.insert (motion);

        if (! driveUnit (drive) && (responseUnit (drive) || isUnknownUnit (drive)))
            labels.insert (drive);
    }

    for (const auto& label : labels)
        remarks.push_back (unknownUnitRemark (source, label));
}

/** Hz of each value. */
Eigen::VectorXd computeAbscissae (const UniversalFunction& function)
{
    const auto count = function.values.size();
    return function.isEven ? Eigen::VectorXd (
               function.first + function.step * Eigen::ArrayXd::LinSpaced (count, 0, static_cast<double> (count - 1)))
                           : function.abscissae;
}

/** Motion and force over time are no impulse responses. */
void refuseForces (const Functions& functions, const UniversalUnits& units, const std::string& source)
{
    if (std::any_of (functions.begin(), functions.end(),
                     [&units] (const auto* function) { return isForceRecord (*function, units); }))
        throw InputError (source, "has time records of a force; allowed: frequency responses, or impulse responses, "
                                  "which 'frf' computes from recordings of force and motion");
}

MeasuredResponse toResponse (const UniversalFunction& function, const UniversalUnits& units, const std::string& source,
                             const std::vector<MeasuredResponse>& earlier)
{
    MeasuredResponse response;
    response.source = source;
    response.unit = findUnit (function, units);
    const auto isAgainst = (function.response.direction < 0) != (function.reference.direction < 0);

    if (function.functionType == timeRecord)
    {
        if (! function.isEven || ! (function.step > 0))
            throw InputError (source,
                              "has an impulse response without a constant time step; allowed: a step above 0 s");

        const auto spectrum = impulseSpectrum (function.values.real(), function.step);
        response.frequencies = sharedFrequencies (spectrum.frequencies, earlier);
        response.values = spectrum.values;
        response.recordLength = spectrum.recordLength;
    }
    else
    {
        response.frequencies = sharedFrequencies (computeAbscissae (function), earlier);
        response.values = function.values;
    }

    response.values *= isAgainst ? -1 : 1;
    response.windowDecay = findWindowDecay (function);
    return response;
}

/** Places for the points that responses have, where all of them have one. */
PointPlaces usedPlaces (const PointPlaces& places, const std::vector<MeasuredResponse>& responses)
{
    PointPlaces used;

    for (const auto& response : responses)
        for (const auto& name : { response.point, response.referencePoint })
            if (const auto place = places.find (name); place != places.end())
                used.insert (*place);

    const auto isPlaced = [&] (const auto& response) { return used.contains (response.point); };
    return std::all_of (responses.begin(), responses.end(), isPlaced) ? used : PointPlaces {};
}
} // namespace

std::optional<ResponseUnit> universalUnit (const UniversalAxis& axis, const UniversalUnits& units)
{
    auto unit = responseUnit (axis.unit);
    return unit ? unit : unitOfCode (axis.quantity, units);
}

bool isForceRecord (const UniversalFunction& function, const UniversalUnits& units)
{
    const auto unit = universalUnit (function.ordinate, units);
    const auto drive = driveUnit (function.ordinate.unit);
    return (drive && drive->drive == DriveQuantity::force) || (unit && ! unit->quantity && unit->drive);
}

UniversalUnits universalUnits (const std::vector<UniversalSet>& sets)
{
    const auto units = findSets<UniversalUnits> (sets);
    return units.empty() ? UniversalUnits {} : *units.front();
}

PointPlaces universalPlaces (const std::vector<UniversalSet>& sets, int normal)
{
    const auto units = universalUnits (sets);
    const Eigen::Index across = normal == 1 ? 1 : 0, up = normal == 2 || normal == 1 ? 2 : 1;
    PointPlaces places;

    for (const auto* nodes : findSets<UniversalNodes> (sets))
        for (std::size_t n = 0; n < nodes->labels.size(); ++n)
        {
            const auto row = static_cast<Eigen::Index> (n);
            places.emplace (std::to_string (nodes->labels[n]),
                            Eigen::Vector2d (nodes->places (row, across), nodes->places (row, up)) / units.length);
        }

    return places;
}

std::string windowDecayLine (double decay)
{
    return std::string (windowWords) + numberText (decay);
}

MeasurementFile measurementFromUniversal (const std::vector<UniversalSet>& sets, const std::string& source)
{
    MeasurementFile file;
    auto functions = findFunctions (sets, frequencyResponse);

    if (functions.empty() && ! (functions = findFunctions (sets, timeRecord)).empty())
        file.remarks.push_back (source + ": the time records are read as impulse responses.");

    if (functions.empty())
        throw InputError (source,
                          "has no frequency response (data set 58 of function type 4, or 1 for impulse responses)");

    const auto units = universalUnits (sets);

    if (functions.front()->functionType == timeRecord)
        refuseForces (functions, units, source);

    const auto axis = commonAxis (functions);
    const auto others = std::erase_if (functions, [&] (const auto* function)
                                       { return std::abs (function->response.direction) != axis; });

    if (others > 0)
        file.remarks.push_back (source + ": " + std::to_string (others)
                                + " responses in minority directions are left out.");

    addUnknownUnits (functions, source, file.remarks);
    const PlaceNames points (functions, &UniversalFunction::response),
        references (functions, &UniversalFunction::reference);
    std::map<std::string, std::set<int>> directions;

    for (const auto* function : functions)
        directions[references.of (function->reference)].insert (std::abs (function->reference.direction));

    for (const auto* function : functions)
    {
        auto response = toResponse (*function, units, source, file.responses);
        response.point = points.of (function->response);
        response.reference = references.of (function->reference);

        if (std::abs (function->reference.direction) == axis && function->reference.node != 0)
            response.referencePoint = response.reference;

        if (directions[response.reference].size() > 1)
            response.reference += ":" + std::to_string (std::abs (function->reference.direction));

        file.responses.push_back (std::move (response));
    }

    file.places = usedPlaces (universalPlaces (sets, axis), file.responses);
    return file;
}

UniversalFunction coherenceSet (UniversalFunction function, const Eigen::VectorXd& values)
{
    constexpr int coherenceType = 6, singleRealType = 2;
    function.functionType = coherenceType;
    function.ordinateType = singleRealType;
    function.lines[0] = "Coherence of velocity and drive";
    function.ordinate = {};
    function.denominator = {};
    function.values = values.cast<std::complex<double>>();
    return function;
}

namespace
{
constexpr int frequencyResponseFunction = 4, alongZ = 3;
constexpr int velocity = 11, force = 13, frequency = 18;

UniversalNodes makeNodes (const Eigen::MatrixX2d& points)
{
    constexpr int colour = 8;
    UniversalNodes nodes;
    nodes.places = Eigen::MatrixX3d::Zero (points.rows(), 3);
    nodes.places.leftCols (2) = points;

    for (Eigen::Index p = 0; p < points.rows(); ++p)
    {
        nodes.labels.push_back (p + 1);
        nodes.systems.push_back ({ 0, 0, colour });
    }

    return nodes;
}

/** The lines at which all responses that have any are finite; none if nothing was measured. */
std::vector<Eigen::Index> finiteLines (const FrequencyResponses& responses)
{
    Eigen::Array<bool, Eigen::Dynamic, 1> areFinite =
        Eigen::Array<bool, Eigen::Dynamic, 1>::Constant (responses.frequencies.size(), true);
    auto isMeasured = false;

    for (const auto& values : responses.values)
        for (const auto& response : values.colwise())
            if (const auto finite = response.array().isFinite().eval(); finite.any())
            {
                areFinite = areFinite && finite;
                isMeasured = true;
            }

    std::vector<Eigen::Index> lines;

    for (Eigen::Index f = 0; f < areFinite.size(); ++f)
        if (isMeasured && areFinite[f])
            lines.push_back (f);

    return lines;
}

/** All that the functions have in common. The abscissa is listed: six digits of a step would not do. */
UniversalFunction commonFunction (const FrequencyResponses& responses, const std::vector<Eigen::Index>& lines)
{
    UniversalFunction function;
    function.encoding = UniversalEncoding::littleEndian;
    function.lines = { "Velocity of points per drive", "Antinode " ANTINODE_VERSION, "NONE", "NONE", "NONE" };
    function.functionType = frequencyResponseFunction;
    function.ordinateType = 6;
    function.isEven = false;
    function.statedCount = static_cast<UniversalLabel> (lines.size());
    function.abscissae = responses.frequencies (lines);
    function.abscissa = { frequency, {}, "Frequency", "Hz" };
    function.ordinate = { velocity, {}, "Velocity", "m/s" };
    function.denominator = responses.drive == DriveQuantity::force ? UniversalAxis { force, {}, "Force", "N" }
                                                                   : UniversalAxis { 0, {}, "Voltage", "V" };
    return function;
}

/** Names of references as ten columns hold them; D1, D2 ... where they would no longer differ. */
std::vector<std::string> entityNames (const std::vector<Reference>& references)
{
    constexpr std::size_t width = 10;
    std::vector<std::string> entities;
    std::set<std::string> different;

    for (const auto& reference : references)
    {
        entities.push_back (plainText (reference.name, width));
        different.insert (entities.back() == "NONE" ? "" : entities.back());
    }

    if (different.size() < references.size() || different.contains (""))
        for (std::size_t i = 0; i < entities.size(); ++i)
            entities[i] = "D" + std::to_string (i + 1);

    return entities;
}
} // namespace

std::vector<UniversalSet> responseSets (const FrequencyResponses& responses)
{
    const auto lines = finiteLines (responses);

    if (lines.empty())
        throw InputError ("frequency responses", "have no line with finite values everywhere; nothing can be written");

    UniversalUnits units { 1, "SI: Meter (newton)", 2, 1, 1, 1, 273.14999999999998 };
    std::vector<UniversalSet> sets { units, makeNodes (responses.points) };
    const auto common = commonFunction (responses, lines);
    const auto entities = entityNames (responses.references);

    for (std::size_t i = 0; i < responses.values.size(); ++i)
        for (Eigen::Index p = 0; p < responses.points.rows(); ++p)
        {
            auto function = common;
            function.identification = static_cast<UniversalLabel> (sets.size());
            function.response = { "NONE", p + 1, alongZ };
            const auto& reference = responses.references[i];
            function.reference = reference.point ? UniversalPlace { entities[i], *reference.point + 1, alongZ }
                                                 : UniversalPlace { entities[i], 0, 0 };
            function.values = responses.values[i].col (p) (lines);

            if (function.values.array().isFinite().all())
                sets.emplace_back (std::move (function));
        }

    return sets;
}
} // namespace antinode
