#include "MatlabResponses.h"

#include "CsvHeading.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <numbers>

namespace antinode
{
namespace
{
using Variables = std::vector<MatlabVariable>;

constexpr std::array<std::string_view, 9> frequencyNames { "f",         "freq",        "freqs",
                                                           "frequency", "frequencies", "frequency_hz",
                                                           "freq_hz",   "f_hz",        "hz" };
constexpr std::array<std::string_view, 3> angularNames { "w", "omega", "om" };
constexpr std::array<std::string_view, 9> responseNames { "h",           "frf",        "frfs",
                                                          "h1",          "hv",         "mobility",
                                                          "accelerance", "receptance", "frequency_responses" };
constexpr std::array<std::string_view, 8> placeNames { "points", "points_mm",   "xy",     "xyz",
                                                       "nodes",  "coordinates", "coords", "geometry" };
constexpr std::array<std::string_view, 4> unitNames { "unit", "units", "quantity", "response_unit" };

/** The name in lower case without the structures it is in. */
std::string shortName (const MatlabVariable& variable)
{
    auto name = variable.name.substr (variable.name.rfind ('.') + 1);
    std::transform (name.begin(), name.end(), name.begin(),
                    [] (unsigned char c) { return static_cast<char> (std::tolower (c)); });
    return name;
}

template <typename Names>
bool isOneOf (const MatlabVariable& variable, const Names& names)
{
    return std::find (names.begin(), names.end(), shortName (variable)) != names.end();
}

bool isVector (const MatlabVariable& variable)
{
    return variable.real.size() > 1 && variable.imaginary.empty()
           && *std::max_element (variable.sizes.begin(), variable.sizes.end()) == variable.real.size();
}

/** What to save instead of an object, which only MATLAB can read; empty where there is none. */
std::string adviceOnObjects (const Variables& variables)
{
    const auto object = std::find_if (variables.begin(), variables.end(),
                                      [] (const auto& variable) { return ! variable.className.empty(); });

    if (object == variables.end())
        return {};

    const auto name = object->name.empty() ? std::string ("G") : object->name;
    return "; objects can be read by MATLAB only: save arrays, of an frd or idfrd by G = chgFreqUnit (" + name
           + ", 'Hz'); f = G.Frequency; H = G.ResponseData; save ('responses.mat', 'f', 'H', '-v7')";
}

/** The variables of a file: "'f' (1001 x 1), 'H' (1001 x 12)". */
std::string inventory (const Variables& variables)
{
    constexpr std::size_t maximum = 8;
    std::string text;

    for (std::size_t i = 0; i < std::min (maximum, variables.size()); ++i)
    {
        text += (i > 0 ? ", " : "") + inQuotes (variables[i].name) + " (";

        if (! variables[i].className.empty())
        {
            text += "an object of class " + variables[i].className + ")";
            continue;
        }

        for (std::size_t s = 0; s < variables[i].sizes.size() && s < maximum; ++s)
            text += (s > 0 ? " x " : "") + std::to_string (variables[i].sizes[s]);

        text += variables[i].imaginary.empty() ? ")" : ", complex)";
    }

    return (variables.empty() ? "no readable variable" : text + (variables.size() > maximum ? " and more" : ""))
           + adviceOnObjects (variables);
}

bool hasSize (const MatlabVariable& variable, std::size_t size)
{
    return std::find (variable.sizes.begin(), variable.sizes.end(), size) != variable.sizes.end();
}

/** Whether a vector could be the frequencies of a complex array, whatever it is called. */
bool couldBeFrequencies (const MatlabVariable& variable, const Variables& variables)
{
    const auto fits = [&] (const auto& each)
    { return ! each.imaginary.empty() && hasSize (each, variable.real.size()); };
    return isVector (variable) && variable.real.front() >= 0
           && std::adjacent_find (variable.real.begin(), variable.real.end(), std::greater_equal<>())
                  == variable.real.end()
           && std::any_of (variables.begin(), variables.end(), fits);
}

const MatlabVariable& frequencyVariable (const Variables& variables, const std::string& source)
{
    const auto isNamed = [] (const auto& each)
    { return isVector (each) && (isOneOf (each, frequencyNames) || isOneOf (each, angularNames)); };
    const auto couldBe = [&] (const auto& each) { return couldBeFrequencies (each, variables); };

    if (const auto named = std::find_if (variables.begin(), variables.end(), isNamed); named != variables.end())
        return *named;

    if (std::count_if (variables.begin(), variables.end(), couldBe) != 1)
        throw InputError (source, "has no vector of frequencies; allowed: one named "
                                      + listed ({ frequencyNames.begin(), frequencyNames.end() }) + " or "
                                      + listed ({ angularNames.begin(), angularNames.end() }) + "; it has "
                                      + inventory (variables));

    return *std::find_if (variables.begin(), variables.end(), couldBe);
}

const MatlabVariable& responseVariable (const Variables& variables, std::size_t lines, const std::string& source)
{
    const auto fits = [&] (const auto& each) { return ! each.imaginary.empty() && hasSize (each, lines); };
    const auto named = std::find_if (variables.begin(), variables.end(),
                                     [&] (const auto& each) { return fits (each) && isOneOf (each, responseNames); });

    if (named != variables.end())
        return *named;

    const auto count = std::count_if (variables.begin(), variables.end(), fits);

    if (count != 1)
        throw InputError (source, "has " + std::to_string (count) + " complex arrays with a size of "
                                      + std::to_string (lines)
                                      + ", the number of frequencies; allowed: one, or the name 'H' or 'FRF'; it has "
                                      + inventory (variables));

    return *std::find_if (variables.begin(), variables.end(), fits);
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

ResponseUnit findUnit (const Variables& variables, const MatlabVariable& responses)
{
    for (const auto& each : variables)
    {
        const auto unit = isOneOf (each, unitNames) ? unitInText (each.text) : std::nullopt;

        if (unit)
            return *unit;
    }

    return quantityWord (shortName (responses)).value_or (ResponseUnit {});
}
} // namespace

MeasurementFile measurementFromMatlab (const std::vector<MatlabVariable>& variables, const std::string& source)
{
    const auto& abscissa = frequencyVariable (variables, source);
    const auto lines = abscissa.real.size();
    const auto& array = responseVariable (variables, lines, source);
    const auto* const places = placeVariable (variables);
    const auto axes = findAxes (array, lines, places != nullptr ? places->sizes[0] : 0, source);
    const auto factor = isOneOf (abscissa, angularNames) ? 1 / (2 * std::numbers::pi) : 1.0;
    MeasurementFile file;
    MeasuredResponse response;
    response.source = source;
    response.unit = findUnit (variables, array);
    response.frequencies = sharedFrequencies (
        factor * Eigen::Map<const Eigen::VectorXd> (abscissa.real.data(), static_cast<Eigen::Index> (lines)), {});
    response.values.resize (static_cast<Eigen::Index> (lines));

    for (std::size_t reference = 0; reference < axes[2].size; ++reference)
        for (std::size_t point = 0; point < axes[1].size; ++point)
        {
            for (std::size_t f = 0; f < lines; ++f)
            {
                const auto at = f * axes[0].stride + point * axes[1].stride + reference * axes[2].stride;
                response.values[static_cast<Eigen::Index> (f)] = { array.real[at], array.imaginary[at] };
            }

            response.point = axes[1].size > 1 ? std::to_string (point + 1) : "";
            response.reference = axes[2].size > 1 ? std::to_string (reference + 1) : "";
            file.responses.push_back (response);
        }

    if (places != nullptr && places->sizes[0] == axes[1].size)
        file.places = readPlaces (*places);

    return file;
}
} // namespace antinode
