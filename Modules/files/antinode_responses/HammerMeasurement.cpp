#include "HammerMeasurement.h"

#include "UniversalResponses.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_text/NaturalOrder.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace antinode
{
namespace
{
constexpr int alongZAxis = 3;

/** One recording as what it is about: who is hit, who moves, in which quantity. */
struct HammerSetup
{
    HammerPoint hit;
    std::vector<HammerPoint> points;
    std::vector<double> signs;
    std::vector<ResponseQuantity> quantities;

    bool isSame (const HammerSetup& other) const { return hit == other.hit && points == other.points; }
};

int axisOrZ (int direction)
{
    return direction == 0 ? alongZAxis : std::abs (direction);
}

double signOf (int direction)
{
    return direction < 0 ? -1 : 1;
}

ResponseUnit motionUnit (const RecordedSignal& signal, const HammerOptions& options)
{
    const auto unit = options.stated.response.value_or (signal.unit);
    return { unit.quantity, unit.factor * options.responseScale, {} };
}

double forceFactor (const RecordedSignal& signal, const HammerOptions& options)
{
    return (options.stated.drive ? options.stated.drive->factor : signal.unit.factor) * options.forceScale;
}

/** Splits a recording into what is measured and what it is about. */
HammerSetup addRecording (const RecordedSignals& signals, const HammerOptions& options, HammerMeasurement& measurement)
{
    HammerSetup setup;
    HammerRecording recording { signals.source, signals.sampleRate, {}, {}, {} };
    const auto motions = std::ssize (signals.signals) - 1;
    recording.fullScales.resize (motions + 1);
    measurement.remarks.insert (measurement.remarks.end(), signals.remarks.begin(), signals.remarks.end());

    for (const auto& signal : signals.signals)
    {
        if (signal.isForce)
        {
            const auto factor = forceFactor (signal, options) * signOf (signal.direction);
            recording.force = factor * signal.samples;
            recording.fullScales[0] = std::abs (factor) * signal.fullScale;
            setup.hit = { options.hitPoint.empty() ? signal.point : options.hitPoint, axisOrZ (signal.direction) };
            continue;
        }

        const auto unit = motionUnit (signal, options);
        const auto row = std::ssize (setup.points);
        recording.responses.conservativeResize (motions, signal.samples.size());
        recording.responses.row (row) = unit.factor * signOf (signal.direction) * signal.samples.transpose();
        recording.fullScales[row + 1] = std::abs (unit.factor) * signal.fullScale;
        setup.points.push_back ({ signal.point, axisOrZ (signal.direction) });
        setup.quantities.push_back (unit.quantity.value_or (ResponseQuantity::velocity));

        if (! unit.quantity)
            measurement.remarks.push_back (signals.source + ": point " + inQuotes (signal.point)
                                           + " has no unit: assumed to be velocity in m/s.");
    }

    measurement.recordings.push_back (std::move (recording));
    return setup;
}

/** Velocity per number of a quantity at i omega + decay. */
Eigen::ArrayXcd velocityPer (ResponseQuantity quantity, const Eigen::VectorXd& frequencies, double decay)
{
    const Eigen::ArrayXcd s =
        std::complex<double> (decay, 0) + std::complex<double> (0, 2 * std::numbers::pi) * frequencies.array();
    return quantity == ResponseQuantity::acceleration   ? Eigen::ArrayXcd (1.0 / s)
           : quantity == ResponseQuantity::displacement ? s
                                                        : Eigen::ArrayXcd::Ones (s.size());
}

/** All points in natural order, each with its axes in theirs. */
std::vector<HammerPoint> allPoints (const std::vector<HammerSetup>& setups)
{
    std::set<HammerPoint> points;
    std::set<std::string> names;

    for (const auto& setup : setups)
        for (const auto& point : setup.points)
        {
            points.insert (point);
            names.insert (point.name);
        }

    std::vector<HammerPoint> ordered;

    for (const auto& name : inNaturalOrder ({ names.begin(), names.end() }))
        for (const auto& point : points)
            if (point.name == name)
                ordered.push_back (point);

    return ordered;
}

Eigen::Index rowOf (const std::vector<HammerPoint>& points, const HammerPoint& point)
{
    return std::find (points.begin(), points.end(), point) - points.begin();
}

/** The places of all points: the user's in the order of the points, the files', or 1 mm apart on a line. */
Eigen::MatrixX2d placesOf (const std::vector<HammerPoint>& points, const std::vector<RecordingFile>& files,
                           const HammerOptions& options)
{
    PointPlaces places;

    for (const auto& file : files)
        places.insert (file.places.begin(), file.places.end());

    std::vector<std::string> names;

    for (const auto& point : points)
        if (names.empty() || names.back() != point.name)
            names.push_back (point.name);

    const auto& stated = options.stated.places; // By their number in the order of the points.

    if (! stated.empty() && stated.size() != names.size())
        throw InputError ("--points", "has " + std::to_string (stated.size()) + " points; allowed: "
                                          + std::to_string (names.size()) + ", as in the recordings");

    Eigen::MatrixX2d rows (std::ssize (points), 2);

    for (std::size_t i = 0, n = 0; i < points.size(); ++i)
    {
        n += i > 0 && points[i].name != points[i - 1].name ? 1 : 0;
        const auto own = places.find (points[i].name);
        const auto given = stated.find (std::to_string (n + 1));
        rows.row (static_cast<Eigen::Index> (i)) = given != stated.end() ? given->second
                                                   : own != places.end()
                                                       ? own->second
                                                       : Eigen::Vector2d (1e-3 * static_cast<double> (n), 0);
    }

    return rows;
}

void fill (HammerMeasurement& measurement, const std::vector<HammerSetup>& setups, const HammerLines& lines,
           const HammerOptions& options)
{
    const auto nan = std::numeric_limits<double>::quiet_NaN();
    const auto count = lines.frequencies.size(), rows = std::ssize (measurement.points);
    std::vector<HammerPoint> hits;
    std::vector<bool> isDone (setups.size(), false);

    for (std::size_t i = 0; i < setups.size(); ++i)
    {
        if (isDone[i])
            continue;

        const auto& setup = setups[i];
        std::vector<std::size_t> same;

        for (std::size_t j = i; j < setups.size(); ++j)
            if (setups[j].isSame (setup))
            {
                same.push_back (j);
                isDone[j] = true;
            }

        const auto estimated =
            hammerResponses (measurement.recordings, measurement.test, lines, same, options.estimator);
        const auto reference = static_cast<std::size_t> (rowOf (hits, setup.hit));

        if (reference == hits.size())
        {
            hits.push_back (setup.hit);
            const auto row = rowOf (measurement.points, setup.hit);
            measurement.responses.references.push_back ({ setup.hit.name.empty() ? "hammer" : setup.hit.name,
                                                          row < rows ? std::optional (row) : std::nullopt });
            measurement.responses.values.emplace_back (
                Eigen::MatrixXcd::Constant (count, rows, std::complex<double> (nan, 0)));
            measurement.coherence.emplace_back (Eigen::MatrixXd::Constant (count, rows, nan));
        }

        for (std::size_t c = 0; c < setup.points.size(); ++c)
        {
            const auto row = rowOf (measurement.points, setup.points[c]), column = static_cast<Eigen::Index> (c);
            measurement.responses.values[reference].col (row) =
                estimated.values.col (column).array()
                * velocityPer (setup.quantities[c], lines.frequencies, measurement.test.windowDecay);

            if (estimated.coherence.size() > 0)
                measurement.coherence[reference].col (row) = estimated.coherence.col (column);
        }
    }
}
} // namespace

HammerMeasurement measureByHammer (const std::vector<RecordingFile>& files, const HammerOptions& options)
{
    HammerMeasurement measurement;
    std::vector<HammerSetup> setups;

    for (const auto& file : files)
        for (const auto& signals : file.recordings)
            setups.push_back (addRecording (signals, options, measurement));

    measurement.test = examineHits (measurement.recordings, options.hits);
    const auto lines =
        drivenLines (measurement.recordings, measurement.test, options.lowestFrequency, options.highestFrequency);
    measurement.points = allPoints (setups);
    measurement.responses.frequencies = lines.frequencies;
    measurement.responses.drive = DriveQuantity::force;
    measurement.responses.points = placesOf (measurement.points, files, options);
    fill (measurement, setups, lines, options);
    return measurement;
}

namespace
{
/** Own numbers where all names are different ones of them, else 1, 2, ... in the order of the points. */
std::vector<UniversalLabel> nodeNumbers (const std::vector<HammerPoint>& points)
{
    constexpr std::size_t mostDigits = 9;
    const auto isNumber = [] (const HammerPoint& point)
    {
        return ! point.name.empty() && point.name.size() <= mostDigits && point.name.front() != '0'
               && point.name.find_first_not_of ("0123456789") == std::string::npos;
    };
    const auto areNumbers = std::all_of (points.begin(), points.end(), isNumber);
    std::vector<UniversalLabel> nodes;

    for (std::size_t i = 0; i < points.size(); ++i)
        if (areNumbers)
            nodes.push_back (std::stoll (points[i].name));
        else if (i > 0 && points[i].name == points[i - 1].name)
            nodes.push_back (nodes.back());
        else
            nodes.push_back (i == 0 ? 1 : nodes.back() + 1);

    return nodes;
}

/** Each node once. */
UniversalNodes withNumbers (const UniversalNodes& rows, const std::vector<UniversalLabel>& numbers)
{
    UniversalNodes nodes;
    std::vector<Eigen::Index> kept;

    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (i == 0 || numbers[i] != numbers[i - 1])
        {
            nodes.labels.push_back (numbers[i]);
            nodes.systems.push_back (rows.systems[i]);
            kept.push_back (static_cast<Eigen::Index> (i));
        }

    nodes.places = rows.places (kept, Eigen::all);
    return nodes;
}
} // namespace

std::vector<UniversalSet> hammerSets (const HammerMeasurement& measurement)
{
    auto sets = responseSets (measurement.responses);
    const auto numbers = nodeNumbers (measurement.points);
    const auto placeOf = [&] (UniversalPlace& place)
    {
        if (place.node == 0)
            return;

        const auto row = static_cast<std::size_t> (place.node - 1);
        place.node = numbers[row];
        place.direction = measurement.points[row].axis;
    };
    std::vector<UniversalSet> coherences;
    std::vector<std::string> entities;

    for (auto& set : sets)
        if (auto* const nodes = std::get_if<UniversalNodes> (&set))
            *nodes = withNumbers (*nodes, numbers);
        else if (auto* const function = std::get_if<UniversalFunction> (&set))
        {
            if (entities.empty() || entities.back() != function->reference.entity)
                entities.push_back (function->reference.entity);

            const Eigen::VectorXd coherence = measurement.coherence[entities.size() - 1].col (
                static_cast<Eigen::Index> (function->response.node - 1));
            placeOf (function->response);
            placeOf (function->reference);

            if (measurement.test.windowDecay > 0)
                function->lines[2] = windowDecayLine (measurement.test.windowDecay);

            if (coherence.allFinite())
                coherences.emplace_back (coherenceSet (*function, coherence));
        }

    sets.insert (sets.end(), coherences.begin(), coherences.end());
    return sets;
}
} // namespace antinode
