#include "MeasuredResponse.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_text/NaturalOrder.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>

namespace antinode
{
namespace
{
/** The position of a name, or else of the number at its end: files of positions often contain numbers only. */
PointPlaces::const_iterator findPlace (const std::string& name, const PointPlaces& places)
{
    const auto found = places.find (name);
    return found != places.end() ? found : places.find (name.substr (name.find_last_not_of ("0123456789") + 1));
}

/** Whether two points have the same position, as in a geometry that was never filled in. */
bool coincide (const Eigen::MatrixX2d& points)
{
    std::set<std::pair<double, double>> seen;
    return std::any_of (points.rowwise().begin(), points.rowwise().end(),
                        [&] (const auto& point) { return ! seen.emplace (point[0], point[1]).second; });
}
} // namespace

void placePoints (const std::vector<MeasurementFile>& files, const MeasurementOptions& options,
                  Measurement& measurement)
{
    constexpr double apart = 1e-3, unlikely = 5; // m
    auto places = options.places;
    auto& points = measurement.responses.points;
    const auto& names = measurement.pointNames;

    for (const auto& file : files)
        places.insert (file.places.begin(), file.places.end());

    points = Eigen::MatrixX2d::Zero (static_cast<Eigen::Index> (names.size()), 2);
    measurement.hasPlaces = true;

    for (std::size_t p = 0; p < names.size(); ++p)
        if (const auto place = findPlace (names[p], places); place != places.end())
            points.row (static_cast<Eigen::Index> (p)) = place->second.transpose();
        else if (! options.places.empty())
            throw InputError ("measurement: point positions",
                              "lack the point " + inQuotes (names[p]) + " of the files");
        else
            measurement.hasPlaces = false;

    if (! measurement.hasPlaces || coincide (points))
    {
        measurement.hasPlaces = false;
        points.col (1).setZero();
        points.col (0) = apart * Eigen::VectorXd::LinSpaced (points.rows(), 0, static_cast<double> (points.rows() - 1));
        measurement.remarks.emplace_back (
            "No file gives positions of all points: they are placed 1 mm apart on a line.");
        return;
    }

    if (const Eigen::RowVector2d span = points.colwise().maxCoeff() - points.colwise().minCoeff();
        options.places.empty() && span.maxCoeff() > unlikely)
        measurement.remarks.push_back (
            formatted ("The points of the files span %g m x %g m. Are their lengths in mm? Use a set 164 of a "
                       "universal file, points_mm of a MATLAB file, or --points.",
                       span[0], span[1]));

    if (points.rows() > 1 && (points.col (0).array() == points (0, 0)).all()) // A line lies along x.
        points.col (0).swap (points.col (1));
}

namespace
{
using Responses = std::vector<MeasuredResponse>;

/** Whether two responses of a list have this name empty and the other the same. */
bool collides (const Responses& responses, std::string MeasuredResponse::*name, std::string MeasuredResponse::*other)
{
    std::set<std::string> seen;
    return std::any_of (responses.begin(), responses.end(),
                        [&] (const auto& response)
                        { return (response.*name).empty() && ! seen.insert (response.*other).second; });
}

/** Points without names are numbered within their file where it has several for a reference. */
void numberColumns (Responses& responses)
{
    std::map<std::string, int> counts, numbers;

    for (const auto& response : responses)
        counts[response.reference] += response.point.empty() ? 1 : 0;

    for (auto& response : responses)
        if (response.point.empty() && counts[response.reference] > 1)
            response.point = std::to_string (++numbers[response.reference]);
}
} // namespace

std::vector<MeasuredResponse> namedResponses (const std::vector<MeasurementFile>& files)
{
    Responses all;
    std::vector<std::size_t> fileNumbers;

    for (std::size_t f = 0; f < files.size(); ++f)
    {
        auto responses = files[f].responses;
        numberColumns (responses);
        fileNumbers.resize (fileNumbers.size() + responses.size(), f + 1);
        std::move (responses.begin(), responses.end(), std::back_inserter (all));
    }

    const auto fill = [&] (std::string MeasuredResponse::*name, std::string MeasuredResponse::*other)
    {
        const auto byFile = collides (all, name, other);

        for (std::size_t i = 0; i < all.size(); ++i)
            if ((all[i].*name).empty())
                all[i].*name = byFile ? std::to_string (fileNumbers[i]) : "1";
    };
    fill (&MeasuredResponse::point, &MeasuredResponse::reference);
    fill (&MeasuredResponse::reference, &MeasuredResponse::point);
    return all;
}

namespace
{
using Responses = std::vector<MeasuredResponse>;

/** The meaning of the numbers of a response, including the user's options. */
ResponseUnit findUnit (const MeasuredResponse& response, const MeasurementOptions& options)
{
    auto unit = response.unit;

    if (options.response)
        unit = { options.response->quantity, options.response->factor,
                 options.response->drive ? options.response->drive : unit.drive };

    if (options.drive)
        unit = { unit.quantity, unit.factor / options.drive->factor, options.drive->drive };

    return unit;
}

/** How the first response is named in a message on another one that differs from it. */
std::string namedBeside (const MeasuredResponse& first, const MeasuredResponse& other)
{
    return first.source == other.source ? "an earlier response of it" : inQuotes (first.source);
}

/** Responses that do not say what was measured are taken to be of the quantity of those that do, and said.
    @return  whether any says it */
bool completeQuantities (Responses& responses, const MeasurementOptions& options, std::vector<std::string>& remarks)
{
    const auto isStated = [&options] (const MeasuredResponse& response)
    { return findUnit (response, options).quantity.has_value(); };
    const auto stated = std::find_if (responses.begin(), responses.end(), isStated);
    const auto silent = std::find_if_not (responses.begin(), responses.end(), isStated);

    if (stated == responses.end() || silent == responses.end())
        return stated != responses.end();

    remarks.push_back (silent->source + " does not give the measured quantity: assumed to be that of "
                       + namedBeside (*stated, *silent) + ".");
    const auto quantity = stated->unit.quantity;

    for (auto& response : responses)
        if (! isStated (response))
            response.unit.quantity = quantity;

    return true;
}

void addDriveRemark (const Responses& responses, const MeasurementOptions& options, std::vector<std::string>& remarks)
{
    if (std::any_of (responses.begin(), responses.end(),
                     [&] (const auto& response) { return ! findUnit (response, options).drive.has_value(); }))
        remarks.emplace_back ("No file says what excites the surface: assumed to be a voltage in V.");
}

DriveQuantity commonDrive (const Responses& responses, const MeasurementOptions& options)
{
    const auto findDrive = [&] (const auto& response)
    { return findUnit (response, options).drive.value_or (DriveQuantity::voltage); };
    const auto first = findDrive (responses.front());

    for (const auto& response : responses)
        if (findDrive (response) != first)
            throw InputError (response.source, "is excited by a different quantity than "
                                                   + namedBeside (responses.front(), response)
                                                   + "; allowed: responses to voltages only or to forces only");

    return first;
}

/** Lines from high to low are reversed. */
void sortDescending (Responses& responses)
{
    std::map<std::shared_ptr<const Eigen::VectorXd>, std::shared_ptr<const Eigen::VectorXd>> turned;

    for (auto& response : responses)
    {
        const auto& lines = *response.frequencies;

        if (std::is_sorted (lines.begin(), lines.end())
            || ! std::is_sorted (lines.begin(), lines.end(), std::greater<>()))
            continue;

        auto& ascending = turned[response.frequencies];

        if (! ascending)
            ascending = std::make_shared<const Eigen::VectorXd> (lines.reverse());

        response.values.reverseInPlace();
        response.frequencies = ascending;
    }
}

void requireSameFrequencies (const MeasuredResponse& first, const MeasuredResponse& other)
{
    constexpr double tolerance = 1e-4; // Of a line's width: files print frequencies with six digits.
    const auto &wanted = *first.frequencies, &found = *other.frequencies;
    const auto lines = wanted.size();
    const auto width = std::abs (wanted[lines - 1] - wanted[0]) / static_cast<double> (lines - 1);
    const auto printed = 1e-5 * wanted.cwiseAbs().maxCoeff();

    if (found.size() != lines
        || (found - wanted).cwiseAbs().maxCoeff() > std::max (tolerance * width, std::min (printed, 0.1 * width)))
        throw InputError (other.source,
                          "has different frequencies from " + namedBeside (first, other)
                              + "; allowed: responses with the same lines; identify the files separately");
}

/** m/s per number of this unit at each frequency. */
Eigen::VectorXcd velocityFactors (const ResponseUnit& unit, const Eigen::VectorXd& frequencies)
{
    const Eigen::VectorXcd differentiation = std::complex<double> (0, 2 * std::numbers::pi) * frequencies;

    switch (unit.quantity.value_or (ResponseQuantity::velocity))
    {
        case ResponseQuantity::displacement:
            return unit.factor * differentiation;
        case ResponseQuantity::acceleration:
            return unit.factor * differentiation.cwiseInverse();
        case ResponseQuantity::velocity:
            break;
    }

    return Eigen::VectorXcd::Constant (frequencies.size(), unit.factor);
}

/** How often what was measured is integrated to give velocities; 0 where responses differ in that. */
int countIntegrations (const Responses& responses, const MeasurementOptions& options)
{
    const auto of = [&options] (const MeasuredResponse& response)
    {
        const auto quantity = findUnit (response, options).quantity.value_or (ResponseQuantity::velocity);
        return quantity == ResponseQuantity::acceleration ? 1 : quantity == ResponseQuantity::displacement ? -1 : 0;
    };
    const auto first = of (responses.front());
    const auto isSame = [&] (const MeasuredResponse& response) { return of (response) == first; };
    return std::all_of (responses.begin(), responses.end(), isSame) ? first : 0;
}

double commonWindowDecay (const Responses& responses)
{
    for (const auto& response : responses)
        if (response.windowDecay != responses.front().windowDecay)
            throw InputError (response.source, "has another exponential window than "
                                                   + namedBeside (responses.front(), response)
                                                   + "; allowed: responses with the same window");

    return responses.front().windowDecay;
}

/** Names in the order of first appearance. */
std::vector<std::string> collectNames (const Responses& responses, std::string MeasuredResponse::*name)
{
    std::vector<std::string> names;
    std::set<std::string> seen;

    for (const auto& response : responses)
        if (seen.insert (response.*name).second)
            names.push_back (response.*name);

    return names;
}

using Indices = std::map<std::string, Eigen::Index>;

Indices indexNames (const std::vector<std::string>& names)
{
    Indices indices;

    for (const auto& name : names)
        indices.emplace (name, static_cast<Eigen::Index> (indices.size()));

    return indices;
}

/** Where forces act at more points than are measured, measured and driven points change places: H_pq = H_qp. */
void exchangeByReciprocity (Responses& responses, DriveQuantity drive, std::vector<std::string>& remarks)
{
    const auto isKnown = [] (const auto& response) { return ! response.referencePoint.empty(); };

    if (drive != DriveQuantity::force || ! std::all_of (responses.begin(), responses.end(), isKnown)
        || collectNames (responses, &MeasuredResponse::referencePoint).size()
               <= collectNames (responses, &MeasuredResponse::point).size())
        return;

    for (auto& response : responses)
    {
        std::swap (response.point, response.referencePoint);
        response.reference = response.referencePoint;
    }

    remarks.emplace_back (
        "Forces act at more points than were measured: points and references are exchanged by reciprocity.");
}

void fillTable (const Responses& responses, const MeasurementOptions& options,
                const std::vector<std::string>& references, Measurement& measurement)
{
    constexpr std::size_t fewest = 64,
                          share = 8; // Of the table; one that is much emptier is a mistake, and takes memory.
    auto& table = measurement.responses;
    const auto& frequencies = *responses.front().frequencies;
    const auto lines = frequencies.size();
    const Eigen::Index skipped = frequencies[0] <= 0 ? 1 : 0; // At 0 Hz nothing has a velocity.
    const auto points = measurement.pointNames.size();

    if (points * references.size() > fewest + share * responses.size())
        throw InputError (responses.front().source,
                          (responses.back().source == responses.front().source ? "has " : "and the other files have ")
                              + std::to_string (points) + " points and " + std::to_string (references.size())
                              + " references, but only " + std::to_string (responses.size())
                              + " responses between them");

    table.frequencies = frequencies.tail (lines - skipped);
    const auto empty = std::complex<double> (std::numeric_limits<double>::quiet_NaN(), 0);
    table.values.assign (references.size(),
                         Eigen::MatrixXcd::Constant (lines - skipped, static_cast<Eigen::Index> (points), empty));
    const auto pointIndices = indexNames (measurement.pointNames), referenceIndices = indexNames (references);
    std::set<std::pair<std::string, std::string>> seen;

    for (const auto& response : responses)
    {
        requireSameFrequencies (responses.front(), response);

        if (! seen.emplace (response.point, response.reference).second)
        {
            measurement.remarks.push_back (response.source + " repeats point " + inQuotes (response.point)
                                           + " and reference " + inQuotes (response.reference)
                                           + ": the first one is used.");
            continue;
        }

        table.values[static_cast<std::size_t> (referenceIndices.at (response.reference))].col (pointIndices.at (
            response.point)) = response.values.tail (lines - skipped)
                                   .cwiseProduct (velocityFactors (findUnit (response, options), table.frequencies));
    }
}

/** The references in the order of the options; or of the first file, which is that of the channels, if it has all; or
    of their numbers. */
std::vector<std::string> referenceNames (const Responses& responses, const MeasurementOptions& options)
{
    auto names = collectNames (responses, &MeasuredResponse::reference);
    std::set<std::string> ofFirstFile;

    for (const auto& response : responses)
        if (response.source == responses.front().source)
            ofFirstFile.insert (response.reference);

    if (options.references.empty())
        return ofFirstFile.size() == names.size() ? names : inNaturalOrder (std::move (names));

    for (const auto& name : names)
        if (std::find (options.references.begin(), options.references.end(), name) == options.references.end())
            throw InputError ("measurement: reference names",
                              "lack the reference " + inQuotes (name) + " of the files");

    return options.references;
}

/** References with the points at which their forces act. */
std::vector<Reference> makeReferences (const Responses& responses, const std::vector<std::string>& names,
                                       const Measurement& measurement)
{
    const auto isForce = measurement.responses.drive == DriveQuantity::force;
    const auto pointIndices = isForce ? indexNames (measurement.pointNames) : Indices {};
    std::map<std::string, std::string> places;
    std::vector<Reference> references;

    for (const auto& response : responses)
        places.emplace (response.reference, response.referencePoint);

    for (const auto& name : names)
    {
        const auto point = pointIndices.find (places[name]);
        references.push_back ({ name, point != pointIndices.end() ? std::optional (point->second) : std::nullopt });
    }

    return references;
}
} // namespace

std::shared_ptr<const Eigen::VectorXd> sharedFrequencies (Eigen::VectorXd frequencies,
                                                          const std::vector<MeasuredResponse>& earlier)
{
    if (! earlier.empty() && *earlier.back().frequencies == frequencies)
        return earlier.back().frequencies;

    return std::make_shared<const Eigen::VectorXd> (std::move (frequencies));
}

Measurement mergedResponses (const std::vector<MeasurementFile>& files, const MeasurementOptions& options)
{
    Measurement measurement;
    auto responses = namedResponses (files);

    if (responses.empty())
        throw InputError ("the files", "contain no frequency response");

    for (const auto& response : responses)
        if (response.frequencies->size() < 2 || response.values.size() != response.frequencies->size())
            throw InputError (response.source, "has a response with fewer than two lines");

    sortDescending (responses);

    for (const auto& file : files)
        measurement.remarks.insert (measurement.remarks.end(), file.remarks.begin(), file.remarks.end());

    auto& table = measurement.responses;
    table.isQuantityStated = completeQuantities (responses, options, measurement.remarks);
    addDriveRemark (responses, options, measurement.remarks);
    table.drive = commonDrive (responses, options);
    table.integrations = countIntegrations (responses, options);
    exchangeByReciprocity (responses, table.drive, measurement.remarks);
    measurement.pointNames = inNaturalOrder (collectNames (responses, &MeasuredResponse::point));
    const auto references = referenceNames (responses, options);
    fillTable (responses, options, references, measurement);
    placePoints (files, options, measurement);
    measurement.recordLength = responses.front().recordLength;
    measurement.windowDecay = commonWindowDecay (responses);

    table.references = makeReferences (responses, references, measurement);
    validate (table);
    return measurement;
}
} // namespace antinode
