#include "RecordedSignals.h"

#include "CsvHeading.h"
#include "CsvResponses.h"
#include "MeasurementReader.h"
#include "UniversalFile.h"
#include "UniversalResponses.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/WholeFile.h>
#include <antinode_text/CsvTable.h>
#include <antinode_text/WaveFile.h>

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
constexpr std::string_view axisLetters = "xyz";

/** 1, 2, 3 of x, y, z; 0 of anything else. */
int axisOf (std::string_view letter)
{
    const auto found = letter.size() == 1 ? axisLetters.find (letter[0]) : std::string_view::npos;
    return found == std::string_view::npos ? 0 : static_cast<int> (found) + 1;
}

std::string digitsOf (const std::string& name)
{
    const auto first = name.find_first_of ("0123456789");
    return first == std::string::npos ? name : name.substr (first);
}

/** The names of all channels: as the user gives them, else the force and points from 1 on. */
std::vector<RecordedSignal> channelsInOrder (const std::vector<std::string>& names, Eigen::Index count,
                                             const std::string& source)
{
    std::vector<RecordedSignal> signals;

    if (! names.empty() && std::ssize (names) != count)
        throw InputError (source, "has " + std::to_string (count) + " channels; allowed: as many as --channels names, "
                                      + std::to_string (names.size()));

    for (Eigen::Index c = 0; c < count; ++c)
        signals.push_back (names.empty() ? namedChannel (c == 0 ? "force" : std::to_string (c), source)
                                         : namedChannel (names[static_cast<std::size_t> (c)], "--channels"));

    return signals;
}

RecordingFile recordingsFromWave (std::string_view bytes, const std::string& source,
                                  const std::vector<std::string>& names)
{
    const auto wave = decodeWave (bytes, source);
    RecordedSignals recording { source, wave.sampleRate, channelsInOrder (names, wave.samples.rows(), source), {} };

    for (std::size_t c = 0; c < recording.signals.size(); ++c)
    {
        recording.signals[c].samples = wave.samples.row (static_cast<Eigen::Index> (c)).transpose();
        recording.signals[c].fullScale = 1;
    }

    return { { recording }, {} };
}

/** Units also stand in brackets, where a single letter is one too: "(g)", "[N]". */
std::string textInBrackets (const std::string& heading)
{
    const auto begin = heading.find_first_of ("([");
    const auto end = heading.find_last_of (")]");
    return begin == std::string::npos || end == std::string::npos || end < begin
               ? std::string()
               : heading.substr (begin + 1, end - begin - 1);
}

/** The unit of a heading: in brackets, or its last word, "force lbf", "acc_g", where a single letter needs a quantity
   before it. */
std::string unitOfHeading (const std::string& heading)
{
    if (heading.find_first_of ("([") != std::string::npos)
        return textInBrackets (heading);

    const auto begin = heading.find_last_of (" _,") + 1; // 0 where there is none.
    const auto last = heading.substr (begin);
    const auto isSaid = unitInText (heading).has_value() || heading.find ("orce") != std::string::npos;
    return begin > 0 && (last.size() > 1 || isSaid) && (responseUnit (last) || driveUnit (last)) ? last : "";
}

/** "P3 x (m/s^2)", "force (N)", "acc 4 -z [g]". */
RecordedSignal signalByHeading (const std::string& heading)
{
    RecordedSignal signal;
    const auto unit = unitOfHeading (heading);
    const auto name = heading.substr (0, std::min (heading.find_first_of ("(["), heading.size() - unit.size()));
    const auto words = splitWords (name);
    const auto has = [&words] (std::string_view word)
    { return std::find (words.begin(), words.end(), word) != words.end(); };
    const auto drive = driveUnit (unit);
    signal.isForce = has ("force") || has ("hammer") || (drive && drive->drive == DriveQuantity::force);
    signal.unit = signal.isForce ? driveUnit (unit).value_or (ResponseUnit { {}, 1, DriveQuantity::force })
                                 : responseUnit (unit).value_or (unitInText (heading).value_or (ResponseUnit {}));

    for (const auto& word : words)
    {
        if (const auto axis = axisOf (word); axis > 0)
            signal.direction = name.find ("-" + word) == std::string::npos ? axis : -axis;
        else if (word.find_first_of ("0123456789") != std::string::npos)
        {
            const auto digits = digitsOf (word);
            const auto last = axisOf (digits.substr (digits.size() - 1));
            signal.direction = last > 0 ? last : signal.direction;
            signal.point = last > 0 ? digits.substr (0, digits.size() - 1) : digits;
        }
    }

    return signal;
}

RecordingFile recordingsFromText (std::string_view bytes, const std::string& source,
                                  const std::vector<std::string>& names)
{
    const auto table = readCsvTable (bytes, source);
    const auto count = table.numbers.cols() - 1;
    const auto words = table.headings.empty() ? std::vector<std::string> {} : splitWords (table.headings.front());
    const auto isMilliseconds = std::find (words.begin(), words.end(), "ms") != words.end();
    RecordedSignals recording {
        source, 1 / samplingInterval (table.numbers.col (0) * (isMilliseconds ? 1e-3 : 1.0), source), {}, {}
    };

    if (names.empty() && ! table.headings.empty())
        for (Eigen::Index c = 1; c <= count; ++c)
        {
            const auto& heading = table.headings[static_cast<std::size_t> (c)];
            recording.signals.push_back (signalByHeading (heading));

            if (const auto unit = textInBrackets (heading); isUnknownUnit (unit))
                recording.remarks.push_back (unknownUnitRemark (source, unit));
        }
    else
        recording.signals = channelsInOrder (names, count, source);

    for (Eigen::Index c = 0; c < count; ++c)
        recording.signals[static_cast<std::size_t> (c)].samples = table.numbers.col (c + 1);

    return { { recording }, {} };
}

/** Points without a name: that of the file, else their numbers. */
void nameChannels (RecordedSignals& recording)
{
    const auto roles = rolesInFileName (recording.source);
    const auto motions = std::count_if (recording.signals.begin(), recording.signals.end(),
                                        [] (const auto& signal) { return ! signal.isForce; });
    int number = 0;

    for (auto& signal : recording.signals)
        if (signal.isForce)
            signal.point = signal.point.empty() ? digitsOf (roles.reference) : signal.point;
        else
        {
            ++number;

            if (motions == 1 && ! roles.point.empty() && (signal.point.empty() || signal.point == "1"))
                signal.point = digitsOf (roles.point);

            signal.point = signal.point.empty() ? std::to_string (number) : signal.point;
        }
}

void requireSameLength (const RecordedSignals& recording)
{
    for (const auto& signal : recording.signals)
        if (signal.samples.size() != recording.signals.front().samples.size())
            throw InputError (recording.source,
                              "has channels of " + std::to_string (recording.signals.front().samples.size()) + " and "
                                  + std::to_string (signal.samples.size()) + " samples; allowed: as many in each");
}

void requireForceAndMotion (const RecordedSignals& recording)
{
    const auto forces = std::count_if (recording.signals.begin(), recording.signals.end(),
                                       [] (const auto& signal) { return signal.isForce; });

    if (forces != 1 || recording.signals.size() < 2)
        throw InputError (recording.source,
                          "has " + std::to_string (forces) + " channels of a force and "
                              + std::to_string (std::ssize (recording.signals) - forces)
                              + " of a motion; allowed: one force and at least one motion; --channels names them");
}
} // namespace

RecordedSignal namedChannel (const std::string& name, const std::string& where)
{
    RecordedSignal signal;
    const auto colon = name.find (':');
    const auto head = name.substr (0, colon),
               tail = colon == std::string::npos ? std::string() : name.substr (colon + 1);
    const auto isAgainst = tail.starts_with ('-');
    signal.isForce = head == "force";
    signal.direction = (isAgainst ? -1 : 1) * axisOf (tail.substr (isAgainst ? 1 : 0));

    if (signal.isForce)
        signal.unit = { {}, 1, DriveQuantity::force };

    if (head.empty() || (! tail.empty() && ! signal.isForce && signal.direction == 0))
        throw InputError (where, inQuotes (name)
                                     + " is not a channel; allowed: force, force:POINT, POINT, POINT:x, y or z, "
                                       "POINT:-x, -y or -z");

    signal.point = signal.isForce ? (signal.direction == 0 ? tail : "") : head;
    return signal;
}

RecordingFile decodeRecordings (std::string_view bytes, const std::string& source,
                                const std::vector<std::string>& channels)
{
    RecordingFile file;

    switch (measurementForm (bytes))
    {
        case MeasurementForm::wave:
            file = recordingsFromWave (bytes, source, channels);
            break;
        case MeasurementForm::matlab:
            file = recordingsFromMatlab (readMatlabFile (bytes, source), source);
            break;
        case MeasurementForm::universal:
            file = recordingsFromUniversal (readUniversalFile (bytes, source), source);
            break;
        case MeasurementForm::text:
            file = recordingsFromText (bytes, source, channels);
            break;
    }

    for (auto& recording : file.recordings)
    {
        nameChannels (recording);
        requireForceAndMotion (recording);
        requireSameLength (recording);
    }

    return file;
}

RecordingFile readRecordings (const std::filesystem::path& path, const std::vector<std::string>& channels)
{
    constexpr FileKind recording { "a recording", std::uintmax_t { 4 } << 30, "cannot be read" };
    return decodeRecordings (readWholeFile (path, recording), path.filename().string(), channels);
}

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
