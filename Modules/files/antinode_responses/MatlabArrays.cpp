#include "MatlabArrays.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace antinode
{
namespace
{
using Variables = std::vector<MatlabVariable>;

constexpr std::array<std::string_view, 16> frequencyNames {
    "f",  "freq",  "freqs", "frequency", "frequencies", "frequency_hz", "freq_hz",        "f_hz",
    "hz", "f_khz", "frq",   "freq_khz",  "fvec",        "f_axis",       "frequency_axis", "frequency_khz"
};
constexpr std::array<std::string_view, 7> angularNames {
    "w", "omega", "om", "w_rad", "omega_rad", "freq_rad", "f_rad"
};
constexpr std::array<std::string_view, 5> startNames { "start_value", "f_start", "fstart", "fmin", "f0" };
constexpr std::array<std::string_view, 4> incrementNames { "increment", "df", "delta_f", "deltaf" };

bool isVector (const MatlabVariable& variable)
{
    return variable.real.size() > 1 && variable.imaginary.empty()
           && *std::max_element (variable.sizes.begin(), variable.sizes.end()) == variable.real.size();
}

bool isScalar (const MatlabVariable& variable)
{
    return variable.real.size() == 1 && variable.imaginary.empty();
}

bool hasSize (const MatlabVariable& variable, std::size_t size)
{
    return std::find (variable.sizes.begin(), variable.sizes.end(), size) != variable.sizes.end();
}

/** Frequencies without a line twice, none below 0. */
bool areAscending (const double* begin, std::size_t count)
{
    return count > 1 && *begin >= 0
           && std::adjacent_find (begin, begin + count, std::greater_equal<>()) == begin + count;
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

/** Two names that say which parts of complex numbers two arrays are. */
struct PartNames
{
    std::string_view first, second;
    bool isPolar = false;
};

constexpr std::array partNames {
    PartNames { "real", "imaginary" },
    PartNames { "real", "imag" },
    PartNames { "re", "im" },
    PartNames { "magnitude", "phase", true },
    PartNames { "magnitude", "angle", true },
    PartNames { "amplitude", "phase", true },
    PartNames { "mag", "phase", true },
    PartNames { "mag", "ang", true },
    PartNames { "amp", "phase", true },
    PartNames { "abs", "angle", true },
    PartNames { "abs", "phase", true },
};

std::string lowerCase (std::string text)
{
    std::transform (text.begin(), text.end(), text.begin(),
                    [] (unsigned char c) { return static_cast<char> (std::tolower (c)); });
    return text;
}

bool contains (const std::string& text, std::string_view part)
{
    return text.find (part) != std::string::npos;
}

/** Places of variables by their names in lower case. */
using Places = std::map<std::string, std::size_t>;

/** A second part: its place, and the name that both parts share. */
using SecondPart = std::pair<std::size_t, std::string>;

/** The variable whose name has the second word in place of the first one, units at their ends apart. */
std::optional<SecondPart> secondPart (const Variables& variables, const Places& places, const MatlabVariable& first,
                                      const PartNames& names)
{
    const auto name = lowerCase (first.name);

    for (auto at = name.find (names.first); at != std::string::npos; at = name.find (names.first, at + 1))
    {
        auto other = name;
        other.replace (at, names.first.size(), names.second);

        if (other.ends_with ("_db"))
            other.resize (other.size() - 3);

        for (const auto* const ending : { "", "_deg", "_rad" })
            if (const auto found = places.find (other + ending);
                found != places.end() && variables[found->second].sizes == first.sizes
                && variables[found->second].imaginary.empty()
                && variables[found->second].real.size() == first.real.size())
            {
                auto stem = first.name;
                const auto mark = at > 0 && stem[at - 1] == '_' ? 1U : 0U;
                stem.erase (at - mark, names.first.size() + mark);
                return SecondPart { found->second, stem.empty() || stem.ends_with ('.') ? stem + "H" : stem };
            }
    }

    return std::nullopt;
}

MatlabVariable joined (const MatlabVariable& first, const MatlabVariable& second, const std::string& name, bool isPolar)
{
    constexpr double halfTurn = 180, decibelsADecade = 20;
    MatlabVariable whole { name, first.sizes, first.real, second.real, {}, {} };
    const auto phaseName = lowerCase (second.name);
    const auto isLarge = std::any_of (second.real.begin(), second.real.end(),
                                      [] (double phase) { return std::abs (phase) > 2 * std::numbers::pi; });
    const auto unit =
        contains (phaseName, "deg") || (! contains (phaseName, "rad") && isLarge) ? std::numbers::pi / halfTurn : 1.0;

    for (std::size_t i = 0; isPolar && i < whole.real.size(); ++i)
    {
        const auto size =
            contains (lowerCase (first.name), "db") ? std::pow (10.0, first.real[i] / decibelsADecade) : first.real[i];
        whole.real[i] = size * std::cos (unit * second.real[i]);
        whole.imaginary[i] = size * std::sin (unit * second.real[i]);
    }

    return whole;
}

/** Variables with pairs of parts as complex arrays. */
Variables withJoinedParts (const Variables& variables)
{
    Variables all;
    std::vector<bool> isUsed (variables.size(), false);
    Places places;

    for (std::size_t i = 0; i < variables.size(); ++i)
        places.emplace (lowerCase (variables[i].name), i);

    for (const auto& names : partNames)
        for (std::size_t i = 0; i < variables.size(); ++i)
            if (! isUsed[i] && variables[i].real.size() > 1 && variables[i].imaginary.empty())
                if (const auto second = secondPart (variables, places, variables[i], names);
                    second && ! isUsed[second->first])
                {
                    isUsed[i] = isUsed[second->first] = true;
                    all.push_back (joined (variables[i], variables[second->first], second->second, names.isPolar));
                }

    for (std::size_t i = 0; i < variables.size(); ++i)
        if (! isUsed[i])
            all.push_back (variables[i]);

    return all;
}

/** Hz per number of a vector of frequencies with this name and unit. */
double frequencyFactor (const MatlabVariable& vector, const Variables& variables)
{
    auto name = shortName (vector);

    for (const auto& each : variables)
        if (const auto other = shortName (each);
            ! each.text.empty() && sharedPath (each, vector) + 1 >= pathOf (vector).size()
            && (other == name + "_unit" || other == name + "_units" || other == "unit_" + name))
            name += lowerCase (each.text);

    return contains (name, "khz")                                     ? 1e3
           : contains (name, "rad") || isOneOf (vector, angularNames) ? 1 / (2 * std::numbers::pi)
                                                                      : 1.0;
}

/** The variable of those that share most with an array's path; nothing where none is suitable. */
template <typename Suits>
const MatlabVariable* nearest (const Variables& variables, const MatlabVariable& array, Suits&& suits)
{
    const MatlabVariable* best = nullptr;

    for (const auto& each : variables)
        if (suits (each) && (best == nullptr || sharedPath (each, array) > sharedPath (*best, array)))
            best = &each;

    return best;
}

bool isFrequencies (const MatlabVariable& variable)
{
    return isVector (variable) && (isOneOf (variable, frequencyNames) || isOneOf (variable, angularNames));
}

/** Frequencies in the first column of an array, which is then removed from it. */
std::optional<ResponseArray> withOwnFrequencies (const MatlabVariable& array)
{
    const auto rows = array.sizes[0];
    const auto isReal = [&] (std::size_t i) { return array.imaginary[i] == 0; };

    if (array.sizes.size() != 2 || array.sizes[1] < 2 || rows < 2 || ! areAscending (array.real.data(), rows))
        return std::nullopt;

    for (std::size_t i = 0; i < rows; ++i)
        if (! isReal (i))
            return std::nullopt;

    ResponseArray own { array,
                        Eigen::Map<const Eigen::VectorXd> (array.real.data(), static_cast<Eigen::Index> (rows)) };
    --own.values.sizes[1];
    const auto taken = static_cast<std::ptrdiff_t> (rows);
    own.values.real.erase (own.values.real.begin(), own.values.real.begin() + taken);
    own.values.imaginary.erase (own.values.imaginary.begin(), own.values.imaginary.begin() + taken);
    return own;
}

/** Frequencies by their first value and increment, as many as an array has lines. */
std::optional<Eigen::VectorXd> steppedFrequencies (const Variables& variables, const MatlabVariable& array)
{
    const auto* const increment =
        nearest (variables, array, [] (const auto& each) { return isScalar (each) && isOneOf (each, incrementNames); });

    if (increment == nullptr || ! (increment->real[0] > 0))
        return std::nullopt;

    const auto* const start = nearest (variables, *increment,
                                       [] (const auto& each) { return isScalar (each) && isOneOf (each, startNames); });
    const auto count = *std::max_element (array.sizes.begin(), array.sizes.end());
    const auto first = start != nullptr ? start->real[0] : 0.0;
    return first
           + increment->real[0]
                 * Eigen::ArrayXd::LinSpaced (static_cast<Eigen::Index> (count), 0, static_cast<double> (count - 1));
}

/** An array with its frequencies, where there are such. */
std::optional<ResponseArray> withFrequencies (const MatlabVariable& array, const Variables& variables)
{
    if (auto own = withOwnFrequencies (array))
        return own;

    const auto fits = [&] (const auto& each) { return isVector (each) && hasSize (array, each.real.size()); };
    const auto* vector =
        nearest (variables, array, [&] (const auto& each) { return isFrequencies (each) && fits (each); });
    const auto couldBe = [&] (const auto& each)
    { return fits (each) && areAscending (each.real.data(), each.real.size()); };

    if (vector == nullptr)
        if (const auto stepped = steppedFrequencies (variables, array))
            return ResponseArray { array, *stepped };

    if (vector == nullptr && std::count_if (variables.begin(), variables.end(), couldBe) == 1)
        vector = &*std::find_if (variables.begin(), variables.end(), couldBe);

    if (vector == nullptr)
        return std::nullopt;

    return ResponseArray { array, frequencyFactor (*vector, variables)
                                      * Eigen::Map<const Eigen::VectorXd> (
                                          vector->real.data(), static_cast<Eigen::Index> (vector->real.size())) };
}

/** Columns of frequencies and of two real numbers for each response. */
std::optional<ResponseArray> withRealColumns (const MatlabVariable& array, CsvForm form)
{
    constexpr std::size_t fewestLines = 8;
    const auto rows = array.sizes.empty() ? 0 : array.sizes[0];

    if (! array.imaginary.empty() || array.sizes.size() != 2 || array.sizes[1] < 3 || array.sizes[1] % 2 == 0
        || rows < fewestLines || array.real.size() != rows * array.sizes[1] || ! areAscending (array.real.data(), rows))
        return std::nullopt;

    const auto responses = (array.sizes[1] - 1) / 2;
    MatlabVariable first { form == CsvForm::decibelDegrees || form == CsvForm::decibelRadians ? "dB" : "",
                           { rows, responses },
                           {},
                           {},
                           {},
                           {} };
    MatlabVariable second { form == CsvForm::magnitudeRadians || form == CsvForm::decibelRadians ? "rad" : "deg",
                            { rows, responses },
                            {},
                            {},
                            {},
                            {} };

    for (std::size_t c = 1; c < array.sizes[1]; ++c)
    {
        auto& part = c % 2 == 1 ? first.real : second.real;
        const auto begin = array.real.begin() + static_cast<std::ptrdiff_t> (c * rows);
        part.insert (part.end(), begin, begin + static_cast<std::ptrdiff_t> (rows));
    }

    const auto isPolar = form != CsvForm::byHeadings && form != CsvForm::realImaginary;
    return ResponseArray { joined (first, second, array.name, isPolar),
                           Eigen::Map<const Eigen::VectorXd> (array.real.data(), static_cast<Eigen::Index> (rows)) };
}

/** Why no array has frequencies. */
[[noreturn]] void failWithoutResponses (const Variables& variables, const std::string& source)
{
    const auto named = std::find_if (variables.begin(), variables.end(), isFrequencies);

    if (named == variables.end())
        throw InputError (
            source,
            "has no vector of frequencies; allowed: one named 'f', 'freq', 'frequency' or 'f_Hz' (Hz), 'f_kHz', 'w' or "
            "'omega' (rad/s), or a first column of frequencies; it has "
                + inventory (variables));

    throw InputError (source, "has 0 complex arrays with a size of " + std::to_string (named->real.size())
                                  + ", the number of frequencies; allowed: one, or the name 'H' or 'FRF'; it has "
                                  + inventory (variables));
}
} // namespace

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

std::vector<std::string> pathOf (const MatlabVariable& variable)
{
    std::vector<std::string> path (1);

    for (const auto character : variable.name)
        if (character == '.')
            path.emplace_back();
        else
            path.back() += character;

    return path;
}

std::size_t sharedPath (const MatlabVariable& one, const MatlabVariable& other)
{
    const auto first = pathOf (one), second = pathOf (other);
    std::size_t shared = 0;

    while (shared < std::min (first.size(), second.size()) && first[shared] == second[shared])
        ++shared;

    return shared;
}

std::vector<ResponseArray> responseArrays (const std::vector<MatlabVariable>& read, CsvForm form,
                                           const std::string& source)
{
    const auto variables = withJoinedParts (read);
    std::vector<ResponseArray> arrays;

    for (const auto& each : variables)
        if (each.imaginary.size() > 1)
            if (auto array = withFrequencies (each, variables))
                arrays.push_back (std::move (*array));

    if (arrays.empty())
        for (const auto& each : variables)
            if (auto array = withRealColumns (each, form))
                arrays.push_back (std::move (*array));

    if (arrays.empty())
        failWithoutResponses (read, source);

    return arrays;
}
} // namespace antinode
