#include "MatlabResponses.h"

#include "CsvHeading.h"
#include "MatlabArrays.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_text/NaturalOrder.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <complex>
#include <iterator>
#include <map>
#include <set>

namespace antinode
{
namespace
{
using Variables = std::vector<MatlabVariable>;

constexpr std::array<std::string_view, 9> responseNames { "h",           "frf",        "frfs",
                                                          "h1",          "hv",         "mobility",
                                                          "accelerance", "receptance", "frequency_responses" };
constexpr std::array<std::string_view, 8> placeNames { "points", "points_mm",   "xy",     "xyz",
                                                       "nodes",  "coordinates", "coords", "geometry" };
constexpr std::array<std::string_view, 5> unitNames { "unit", "units", "quantity", "response_unit", "label" };

using Arrays = std::vector<ResponseArray>;

/** Whether a name says that an array is a spectrum or a coherence, not a response. */
bool isSpectrum (const ResponseArray& array)
{
    constexpr std::array<std::string_view, 9> parts {
        "spec", "cross", "auto", "psd", "csd", "coh", "gxx", "gxy", "gyy"
    };
    const auto name = shortName (array.values);
    return std::any_of (parts.begin(), parts.end(), [&] (auto part) { return name.find (part) != std::string::npos; });
}

/** "'H1', 'H2' and more". */
std::string namesOf (const Arrays& arrays)
{
    constexpr std::size_t most = 8;
    std::vector<std::string_view> names;

    for (const auto& array : arrays)
        if (names.size() < most)
            names.emplace_back (array.values.name);

    return listed (names) + (arrays.size() > most ? " and more" : "");
}

/** The arrays with the names that the user gives, in full or without the structures they are in. */
Arrays namedArrays (const Arrays& all, const std::vector<std::string>& names, const std::string& source)
{
    Arrays chosen;

    for (const auto& name : names)
    {
        const auto before = chosen.size();
        std::copy_if (all.begin(), all.end(), std::back_inserter (chosen),
                      [&] (const auto& array) {
                          return array.values.name == name || shortName (array.values) == name
                                 || pathOf (array.values).back() == name;
                      });

        if (chosen.size() == before)
            throw InputError (source, "has no responses in a variable " + inQuotes (name)
                                          + "; allowed for --variables: " + namesOf (all));
    }

    return chosen;
}

/** Whether two arrays estimate the same responses, as H1 and H2 of one measurement do. */
bool areEstimatesOfOne (const Arrays& arrays)
{
    constexpr double close = 0.1;

    if (arrays.size() != 2 || shortName (arrays[0].values) != "h1" || shortName (arrays[1].values) != "h2"
        || arrays[0].values.sizes != arrays[1].values.sizes)
        return false;

    double difference = 0, power = 0;

    for (std::size_t i = 0; i < arrays[0].values.real.size(); ++i)
    {
        const std::complex<double> one (arrays[0].values.real[i], arrays[0].values.imaginary[i]),
            other (arrays[1].values.real[i], arrays[1].values.imaginary[i]);
        difference += std::norm (one - other);
        power += std::norm (one);
    }

    return difference < close * close * power;
}

/** The arrays that are read where the user names none: the only one, or all of those whose names differ in numbers; of
   several kinds the one with a name of responses, or that is no spectrum.
    @param left  gets those that are not read */
Arrays chosenArrays (const Arrays& all, Arrays& left, const std::string& source)
{
    std::map<std::string, Arrays> kinds; // By the forms of their names.

    for (const auto& array : all)
        kinds[numberedName (array.values.name).form].push_back (array);

    const auto isNamed = [] (const auto& kind)
    {
        return std::any_of (kind.second.begin(), kind.second.end(),
                            [] (const auto& array) { return isOneOf (array.values, responseNames); });
    };
    const auto isResponse = [] (const auto& kind) { return ! isSpectrum (kind.second.front()); };
    auto chosen = kinds.begin();

    if (kinds.size() > 1)
    {
        if (std::count_if (kinds.begin(), kinds.end(), isNamed) >= 1)
            chosen = std::find_if (kinds.begin(), kinds.end(), isNamed);
        else if (std::count_if (kinds.begin(), kinds.end(), isResponse) == 1)
            chosen = std::find_if (kinds.begin(), kinds.end(), isResponse);
        else
            throw InputError (source,
                              "has " + std::to_string (all.size())
                                  + " complex arrays with as many lines as frequencies; allowed: one, arrays whose "
                                    "names differ in numbers, or the name 'H' or 'FRF'; --variables names those "
                                    "to read: "
                                  + namesOf (all));
    }

    for (auto kind = kinds.begin(); kind != kinds.end(); ++kind)
        if (kind != chosen)
            left.insert (left.end(), kind->second.begin(), kind->second.end());

    auto arrays = chosen->second;

    if (areEstimatesOfOne (arrays))
    {
        left.push_back (arrays.back());
        arrays.pop_back();
    }

    return arrays;
}

/** Point and reference that a variable's name says. */
struct VariableRole
{
    std::string point, reference;
};

/** What tells several variables apart: one number of their names is the point, of two the second one the reference;
   names without numbers are points themselves. */
std::vector<VariableRole> rolesOf (const Arrays& arrays)
{
    std::vector<NumberedName> names;

    for (const auto& array : arrays)
        names.push_back (numberedName (array.values.name));

    const auto isAlike = [&] (const auto& name) { return name.form == names.front().form; };
    const auto areAlike = std::all_of (names.begin(), names.end(), isAlike);
    std::vector<VariableRole> roles (arrays.size());

    for (std::size_t i = 0; i < arrays.size() && arrays.size() > 1; ++i)
        for (std::size_t n = 0; n < (areAlike ? names[i].numbers.size() : 1); ++n)
        {
            const auto isSame = [&] (const auto& name) { return name.numbers[n] == names.front().numbers[n]; };

            if (! areAlike)
                roles[i].point = pathOf (arrays[i].values).back();
            else if (! std::all_of (names.begin(), names.end(), isSame))
                (roles[i].point.empty() ? roles[i].point : roles[i].reference) += names[i].numbers[n];
        }

    return roles;
}

/** An axis of an array: how many entries it has, how far apart they are. */
struct Axis
{
    std::size_t size = 1, stride = 1;
};

/** The axes of lines, points and references. */
std::array<Axis, 3> findAxes (const MatlabVariable& responses, std::size_t lines, std::size_t places,
                              const std::string& source)
{
    std::array<Axis, 3> axes;
    std::vector<Axis> others;
    std::size_t stride = 1;
    auto hasLines = false;

    for (const auto size : responses.sizes)
    {
        if (size == lines && ! hasLines)
        {
            axes[0] = { size, stride };
            hasLines = true;
        }
        else if (size > 1)
            others.push_back ({ size, stride });

        stride *= size;
    }

    if (others.size() > 2)
        throw InputError (source, "variable " + inQuotes (responses.name)
                                      + " has more than three dimensions; allowed: lines, points and references");

    others.resize (2);
    const auto isExchanged = others[1].size == places || (others[0].size != places && others[1].size > others[0].size);
    axes[1] = others[isExchanged ? 1 : 0];
    axes[2] = others[isExchanged ? 0 : 1];
    return axes;
}

const MatlabVariable* placeVariable (const Variables& variables)
{
    const auto found = std::find_if (variables.begin(), variables.end(),
                                     [] (const auto& each)
                                     {
                                         return isOneOf (each, placeNames) && each.imaginary.empty()
                                                && each.sizes.size() == 2 && each.sizes[1] >= 2 && each.sizes[1] <= 3;
                                     });
    return found == variables.end() || found->real.empty() ? nullptr : &*found;
}

PointPlaces readPlaces (const MatlabVariable& variable)
{
    const auto factor = shortName (variable).ends_with ("_mm") ? 1e-3 : 1.0;
    const auto count = variable.sizes[0];
    PointPlaces places;

    for (std::size_t p = 0; p < count; ++p)
        places.emplace (std::to_string (p + 1),
                        Eigen::Vector2d (factor * variable.real[p], factor * variable.real[p + count]));

    return places;
}

/** The unit of an array: by the text of the structure it is in, or of one around it, or by its name. */
ResponseUnit findUnit (const Variables& variables, const MatlabVariable& responses, const std::string& source,
                       std::vector<std::string>& remarks)
{
    const MatlabVariable* best = nullptr;

    for (const auto& each : variables)
        if (isOneOf (each, unitNames) && ! each.text.empty()
            && (shortName (each) != "label" || sharedPath (each, responses) > 0)
            && (best == nullptr || sharedPath (each, responses) > sharedPath (*best, responses)))
            best = &each;

    if (best != nullptr)
    {
        if (const auto unit = responseUnit (best->text))
            return *unit;

        if (const auto unit = unitInText (best->text))
            return *unit;

        if (const auto remark = unknownUnitRemark (source, best->text);
            isUnknownUnit (best->text) && std::find (remarks.begin(), remarks.end(), remark) == remarks.end())
            remarks.push_back (remark);
    }

    return quantityWord (shortName (responses)).value_or (ResponseUnit {});
}

/** The responses of an array, of which a variable's name may say point or reference. */
void addResponses (const ResponseArray& array, const VariableRole& role, std::size_t places, MeasuredResponse response,
                   MeasurementFile& file)
{
    const auto& values = array.values;
    const auto lines = static_cast<std::size_t> (array.frequencies.size());
    const auto axes = findAxes (values, lines, places, response.source);
    response.frequencies = sharedFrequencies (array.frequencies, file.responses);
    response.values.resize (array.frequencies.size());
    const auto hasPoints = axes[1].size > 1;
    const auto nameOf = [] (const Axis& axis, std::size_t index, const std::string& otherwise)
    { return axis.size > 1 ? std::to_string (index + 1) : otherwise; };

    for (std::size_t reference = 0; reference < axes[2].size; ++reference)
        for (std::size_t point = 0; point < axes[1].size; ++point)
        {
            for (std::size_t f = 0; f < lines; ++f)
            {
                const auto at = f * axes[0].stride + point * axes[1].stride + reference * axes[2].stride;
                response.values[static_cast<Eigen::Index> (f)] = { values.real[at], values.imaginary[at] };
            }

            // A variable with several points is one of several references.
            response.point = nameOf (axes[1], point, role.point);
            response.reference =
                nameOf (axes[2], reference, hasPoints && role.reference.empty() ? role.point : role.reference);
            file.responses.push_back (response);
        }
}
} // namespace

MeasurementFile measurementFromMatlab (const std::vector<MatlabVariable>& variables, const std::string& source,
                                       CsvForm form, const std::vector<std::string>& names)
{
    const auto all = responseArrays (variables, form, source);
    MeasurementFile file;
    Arrays left;
    const auto arrays = names.empty() ? chosenArrays (all, left, source) : namedArrays (all, names, source);
    const auto roles = rolesOf (arrays);
    const auto* const places = placeVariable (variables);
    std::set<std::string> points;

    if (! left.empty())
        file.remarks.push_back (source + ": " + namesOf (arrays) + " is read, " + namesOf (left)
                                + " is not; --variables names others.");

    for (std::size_t i = 0; i < arrays.size(); ++i)
    {
        MeasuredResponse response;
        response.source = source;
        response.unit = findUnit (variables, arrays[i].values, source, file.remarks);
        addResponses (arrays[i], roles[i], places != nullptr ? places->sizes[0] : 0, response, file);
    }

    for (const auto& response : file.responses)
        points.insert (response.point);

    if (places != nullptr && places->sizes[0] == points.size())
        file.places = readPlaces (*places);

    return file;
}
} // namespace antinode
