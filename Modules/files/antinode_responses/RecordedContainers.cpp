#include "RecordedContainers.h"

#include "CsvHeading.h"
#include "CsvResponses.h"
#include "UniversalResponses.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <tuple>

namespace antinode
{
namespace
{
const MatlabVariable* findVariable (const std::vector<MatlabVariable>& variables,
                                    const std::vector<std::string_view>& names)
{
    for (const auto name : names)
        for (const auto& variable : variables)
            if (shortName (variable) == name && ! variable.real.empty() && variable.imaginary.empty())
                return &variable;

    return nullptr;
}

Eigen::Map<const Eigen::VectorXd> numbersOf (const MatlabVariable& variable)
{
    return { variable.real.data(), static_cast<Eigen::Index> (variable.real.size()) };
}

double matlabRate (const std::vector<MatlabVariable>& variables, const std::string& source)
{
    if (const auto* const rate = findVariable (variables, { "fs", "sample_rate", "rate" });
        rate != nullptr && rate->real.size() == 1 && rate->real[0] > 0)
        return rate->real[0];

    if (const auto* const interval = findVariable (variables, { "dt", "interval" });
        interval != nullptr && interval->real.size() == 1 && interval->real[0] > 0)
        return 1 / interval->real[0];

    if (const auto* const times = findVariable (variables, { "t", "time" }); times != nullptr && times->real.size() > 1)
        return 1 / samplingInterval (numbersOf (*times), source);

    throw InputError (source,
                      "has no times of its samples; allowed: a vector 't' or 'time' (s), a rate 'fs' (Hz) or an "
                      "interval 'dt' (s)");
}

constexpr std::array<std::string_view, 13> motionNames { "acceleration", "accelerations", "acc",  "a",
                                                         "velocity",     "velocities",    "vel",  "v",
                                                         "displacement", "displacements", "disp", "response",
                                                         "responses" };

/** The text of a variable with one of these names; empty where there is none. */
std::string textNamed (const std::vector<MatlabVariable>& variables, const std::vector<std::string_view>& names)
{
    for (const auto& variable : variables)
        if (std::find (names.begin(), names.end(), shortName (variable)) != names.end())
            return variable.text;

    return {};
}

/** The quantity that a motion's name means. */
ResponseUnit unitByName (std::string name)
{
    name = name.substr (name.rfind ('.') + 1);
    const auto first = static_cast<char> (std::tolower (static_cast<unsigned char> (name.empty() ? 'r' : name[0])));
    ResponseUnit unit;

    if (first != 'r')
        unit.quantity = first == 'a'   ? ResponseQuantity::acceleration
                        : first == 'v' ? ResponseQuantity::velocity
                                       : ResponseQuantity::displacement;

    return unit;
}

constexpr int timeRecordType = 1;

RecordedSignal toSignal (const UniversalFunction& function, const UniversalUnits& units)
{
    RecordedSignal signal;
    signal.isForce = isForceRecord (function, units);
    signal.point = function.response.node != 0 ? std::to_string (function.response.node) : "";
    signal.direction = function.response.direction;
    signal.unit = universalUnit (function.ordinate, units)
                      .value_or (driveUnit (function.ordinate.unit).value_or (ResponseUnit {}));

    // A code says 1 / (units per newton), a unit newtons per unit: both as factor of a force.
    if (signal.isForce)
        signal.unit =
            driveUnit (function.ordinate.unit).value_or (ResponseUnit { {}, 1 / units.force, DriveQuantity::force });

    signal.samples = function.values.real();
    return signal;
}
} // namespace

RecordingFile recordingsFromMatlab (const std::vector<MatlabVariable>& variables, const std::string& source)
{
    const auto* const force = findVariable (variables, { "force", "f", "hammer" });
    const auto* const motion = findVariable (variables, { motionNames.begin(), motionNames.end() });

    if (force == nullptr || motion == nullptr)
        throw InputError (source,
                          "has no recording of a hammer; allowed: a vector 'force' and an array 'acceleration', "
                          "'velocity', 'displacement' or 'response'");

    const auto samples = static_cast<Eigen::Index> (force->real.size());
    const auto channels = static_cast<Eigen::Index> (motion->real.size()) / samples;

    if (motion->sizes.size() != 2 || channels * samples != static_cast<Eigen::Index> (motion->real.size()))
        throw InputError (source, "variable '" + motion->name + "' does not fit the " + std::to_string (samples)
                                      + " samples of the force; allowed: samples x channels, or channels x samples");

    RecordedSignals recording { source, matlabRate (variables, source), {}, {} };
    const auto motionText = textNamed (variables, { "unit", "units", "response_unit" }),
               forceText = textNamed (variables, { "force_unit", "drive_unit" });
    const auto motionUnit = responseUnit (motionText).value_or (unitByName (motion->name));
    const auto forceUnit = driveUnit (forceText).value_or (ResponseUnit { {}, 1, DriveQuantity::force });
    recording.signals.push_back ({ true, {}, 0, forceUnit, 0, numbersOf (*force) });

    for (const auto& text : { motionText, forceText })
        if (isUnknownUnit (text))
            recording.remarks.push_back (unknownUnitRemark (source, text));

    const auto areColumns = static_cast<Eigen::Index> (motion->sizes[0]) == samples;

    for (Eigen::Index c = 0; c < channels; ++c)
        recording.signals.push_back (
            { false, std::to_string (c + 1), 0, motionUnit, 0,
              areColumns ? Eigen::VectorXd (numbersOf (*motion).segment (c * samples, samples))
                         : Eigen::VectorXd (numbersOf (*motion) (Eigen::seqN (c, samples, channels))) });

    return { { recording }, {} };
}

RecordingFile recordingsFromUniversal (const std::vector<UniversalSet>& sets, const std::string& source)
{
    const auto units = universalUnits (sets);
    RecordingFile file;
    std::map<std::tuple<bool, std::string, int>, std::size_t> occurrences;

    for (const auto& set : sets)
    {
        const auto* const function = std::get_if<UniversalFunction> (&set);

        if (function == nullptr || function->functionType != timeRecordType || function->values.size() < 2)
            continue;

        if (! function->isEven || ! (function->step > 0))
            throw InputError (source, "has a time record without a constant time step; allowed: a step above 0 s");

        auto signal = toSignal (*function, units);
        const auto& unit = function->ordinate.unit;
        // The n-th record of a channel belongs to the n-th one of all others.
        const auto number = occurrences[{ signal.isForce, signal.point, signal.direction }]++;

        if (number == file.recordings.size())
            file.recordings.push_back ({ source, 1 / function->step, {}, {} });

        if (number == 0 && isUnknownUnit (unit))
            file.recordings.front().remarks.push_back (unknownUnitRemark (source, unit));

        file.recordings[std::min (number, file.recordings.size() - 1)].signals.push_back (std::move (signal));
    }

    if (file.recordings.empty())
        throw InputError (source, "has no time record (data set 58 of function type 1)");

    file.places = universalPlaces (sets, 0);
    return file;
}
} // namespace antinode
