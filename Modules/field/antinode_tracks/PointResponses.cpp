#include "PointResponses.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <antinode_fingers/LoadedModel.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/ParallelFor.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;

/** The modal equations at the points and the loads together: what a line needs. */
struct LineSystem
{
    Eigen::MatrixXd shapes; ///< (points + loads) x N_m
    Eigen::MatrixXd inputs; ///< N_m x (actuators + loads)
    Eigen::Index points = 0, actuators = 0, loads = 0;
};

LineSystem lineSystem (const ModalModel& model, const Eigen::MatrixXd& pointShapes,
                       const std::vector<SurfaceLoad>& loads)
{
    LineSystem system;
    system.points = pointShapes.rows();
    system.actuators = model.actuators();
    system.loads = static_cast<Eigen::Index> (loads.size());
    system.shapes.resize (system.points + system.loads, model.modes());
    system.shapes.topRows (system.points) = pointShapes;

    for (std::size_t f = 0; f < loads.size(); ++f)
        system.shapes.row (system.points + static_cast<Eigen::Index> (f)) = loads[f].shapes;

    system.inputs.resize (model.modes(), system.actuators + system.loads);
    system.inputs.leftCols (system.actuators) = model.participation;
    system.inputs.rightCols (system.loads) = system.shapes.bottomRows (system.loads).transpose();
    return system;
}

/** Displacement at points for voltages. Loads are added one by one: each is a term of rank one (Sherman and Morrison).
 */
Eigen::MatrixXcd responseAt (const LineSystem& system, const Eigen::VectorXcd& compliances,
                             const Eigen::VectorXcd& impedances)
{
    const Eigen::MatrixXd real = system.shapes * compliances.real().asDiagonal() * system.inputs;
    const Eigen::MatrixXd imaginary = system.shapes * compliances.imag().asDiagonal() * system.inputs;
    Eigen::MatrixXcd response = real.cast<Complex>() + Complex (0, 1) * imaginary.cast<Complex>();

    for (Eigen::Index f = 0; f < system.loads; ++f)
    {
        const Eigen::VectorXcd byForce = response.col (system.actuators + f);
        const Eigen::RowVectorXcd atLoad = response.row (system.points + f);
        response -= byForce * (impedances[f] / (1.0 + impedances[f] * byForce[system.points + f])) * atLoad;
    }

    return response.topLeftCorner (system.points, system.actuators);
}
} // namespace

Eigen::MatrixXcd PointResponses::atLine (Eigen::Index line) const
{
    const Eigen::RowVectorXcd row = values.row (line);
    return Eigen::Map<const Eigen::MatrixXcd> (row.data(), points, actuators);
}

PointResponses pointResponses (const ModalModel& model, const Eigen::MatrixXd& pointShapes,
                               const std::vector<SurfaceLoad>& loads, double sampleRate, Eigen::Index length)
{
    requireRealModes (model, "waveforms at points");
    const auto system = lineSystem (model, pointShapes, loads);
    PointResponses responses { system.points, system.actuators, length, sampleRate, {} };
    responses.values.resize (length / 2 + 1, system.points * system.actuators);
    const auto squares = model.angularFrequencies.array().square();
    const auto dampings = 2 * model.dampingRatios.array() * model.angularFrequencies.array();

    const auto atLine = [&] (std::size_t line)
    {
        checkWatch();
        const auto omega =
            2 * std::numbers::pi * sampleRate * static_cast<double> (line) / static_cast<double> (length);
        Eigen::VectorXcd compliances (model.modes()), impedances (system.loads);

        for (Eigen::Index k = 0; k < model.modes(); ++k)
            compliances[k] = 1.0 / Complex (squares[k] - omega * omega, dampings[k] * omega);

        for (std::size_t f = 0; f < loads.size(); ++f)
            impedances[static_cast<Eigen::Index> (f)] =
                Complex (loads[f].stiffness - loads[f].mass * omega * omega, loads[f].damping * omega);

        const auto response = responseAt (system, compliances, impedances);
        responses.values.row (static_cast<Eigen::Index> (line)) =
            Eigen::Map<const Eigen::RowVectorXcd> (response.data(), response.size());
    };
    parallelFor (static_cast<std::size_t> (length / 2 + 1), atLine);
    return responses;
}

namespace
{
constexpr double leastDifference = 0.05;  // of the motion of two points: less cannot be told apart
constexpr double lookedAgainAfter = 3e-3; // m that points move
constexpr double distanceStep = 2.5e-4;   // m, in which the least distance is looked for

/** How much of the motion of each pair is its own, the median over the band: 0 where two points move alike. */
double differenceOf (const PointResponses& responses, TrackBand band, Eigen::Index p, Eigen::Index q)
{
    const auto step = responses.sampleRate / static_cast<double> (responses.length);
    std::vector<double> shares;

    for (auto line = static_cast<Eigen::Index> (std::ceil (band.lower / step));
         line <= static_cast<Eigen::Index> (band.upper / step); ++line)
    {
        const auto response = responses.atLine (line);
        const auto alike = std::norm (response.row (p).dot (response.row (q)));
        const auto both = response.row (p).squaredNorm() * response.row (q).squaredNorm();
        shares.push_back (both > 0 ? std::sqrt (std::max (0.0, 1 - alike / both)) : 0);
    }

    return median (shares);
}

/** The responses at lines 10 Hz apart: enough to compare points by. */
PointResponses coarseResponses (const ModalModel& model, const Eigen::MatrixXd& shapes, TrackBand band)
{
    constexpr double spacing = 10; // Hz
    const auto rate = 4 * band.upper;
    return pointResponses (model, shapes, {}, rate, 2 * static_cast<Eigen::Index> (std::ceil (rate / spacing / 2)));
}

/** The least distance from a point, in a direction, at which another one is told apart; none on the surface. */
std::optional<double> leastDistance (const ModalModel& model, TrackBand band, const TouchedPoint& from,
                                     const TouchedPoint& to)
{
    const auto distance = std::hypot (to.x - from.x, to.y - from.y);
    const auto alongX = distance > 0 ? (to.x - from.x) / distance : 1;
    const auto alongY = distance > 0 ? (to.y - from.y) / distance : 0;
    const auto& surface = model.surface;

    for (auto far = distanceStep * (std::floor (distance / distanceStep) + 1);; far += distanceStep)
    {
        const auto x = from.x + far * alongX, y = from.y + far * alongY;

        if (! liesOn (surface, x, y))
            return {};

        Eigen::MatrixXd shapes (2, model.coordinates());
        shapes << shapesAt (model, from.x, from.y), shapesAt (model, x, y);

        if (differenceOf (coarseResponses (model, shapes, band), band, 0, 1) >= leastDifference)
            return far;
    }
}

/** The same of points that stay. @param when  for messages */
void requireDistinct (const ModalModel& model, const WaveformsDescription& description, const std::string& when)
{
    const auto points = touchedPoints (description);
    const auto responses = coarseResponses (model, touchedShapes (model, description), description.band);

    for (std::size_t q = 1; q < points.size(); ++q)
        for (std::size_t p = 0; p < q; ++p)
            if (differenceOf (responses, description.band, static_cast<Eigen::Index> (p), static_cast<Eigen::Index> (q))
                < leastDifference)
            {
                const auto least = leastDistance (model, description.band, points[p], points[q]);
                const auto distance = std::hypot (points[q].x - points[p].x, points[q].y - points[p].y);
                throw InputError (
                    "waveforms: " + pointInWords (description, q),
                    "is " + inWords (distance * milli) + " mm from " + pointInWords (description, p) + when
                        + ", too near for the surface to move them apart"
                        + (least ? "; allowed: " + inWords (*least * milli) + " mm or more in this direction"
                                 : "; allowed: another place"));
            }
}
} // namespace

std::vector<SurfaceLoad> touchedLoads (const ModalModel& model, const WaveformsDescription& description)
{
    std::vector<SurfaceLoad> loads;

    for (const auto& point : touchedPoints (description))
        if (const auto& finger = point.finger; finger && finger->isKnown)
        {
            requireKnownScale (model, "fingers");
            loads.push_back ({ contactShapes (model, *finger), finger->mass, finger->damping, finger->stiffness });
        }

    return loads;
}

void requireEnoughCeramics (const ModalModel& model, const WaveformsDescription& description)
{
    const auto points = description.tracks.size() + description.silent.size();

    if (static_cast<Eigen::Index> (points) > model.actuators())
        throw InputError ("waveforms", "touch " + std::to_string (points) + " points; allowed: at most "
                                           + std::to_string (model.actuators()) + ", one per ceramic");
}

void requireDistinctPoints (const ModalModel& model, const WaveformsDescription& description)
{
    const auto times = timesOfPlaces (description, lookedAgainAfter);
    auto places = description;

    for (auto& track : places.tracks)
        track.events.clear(); // A recording is long, and would be copied every time.

    for (const auto time : times)
        requireDistinct (model, stillAt (places, time),
                         times.size() > 1 ? " at " + inWords (time * milli) + " ms" : std::string());
}

namespace
{
using Complex = std::complex<double>;
using Lines = Eigen::ArrayXcd;

constexpr double farAbove = 2;     // times the highest frequency: beyond it modes are a series
constexpr Eigen::Index terms = 10; // of it: it converges as farAbove^-terms

/** 1 / (omega_k^2 + 2 xi_k omega_k s + s^2) in powers of s. */
Eigen::VectorXd powerSeries (double angularFrequency, double dampingRatio)
{
    const auto first = 2 * dampingRatio / angularFrequency, second = 1 / (angularFrequency * angularFrequency);
    Eigen::VectorXd coefficients (terms);
    coefficients[0] = second;
    coefficients[1] = -first * second;

    for (Eigen::Index n = 2; n < terms; ++n)
        coefficients[n] = -first * coefficients[n - 1] - second * coefficients[n - 2];

    return coefficients;
}

/** The lines of all pairs of a row (points, then loads) and an input (ceramics, then loads): column row + rows input.
 */
struct LoadedLines
{
    Eigen::MatrixXcd values;
    Eigen::Index points, actuators, loads;

    auto at (Eigen::Index row, Eigen::Index input) { return values.col (row + (points + loads) * input).array(); }
};

/** Sherman and Morrison's identity for one load, for what is needed after it. */
void addLoad (LoadedLines& lines, Eigen::Index load, const Lines& impedance)
{
    const auto row = lines.points + load, input = lines.actuators + load;
    const Lines factor = impedance / (1 + impedance * lines.at (row, input));
    const auto isNeeded = [&] (Eigen::Index index, Eigen::Index own, Eigen::Index first)
    { return index < first || index > own; };

    for (Eigen::Index i = 0; i < lines.actuators + lines.loads; ++i)
    {
        if (! isNeeded (i, input, lines.actuators))
            continue;

        const Lines force = factor * lines.at (row, i);

        for (Eigen::Index p = 0; p < lines.points + lines.loads; ++p)
            if (isNeeded (p, row, lines.points))
                lines.at (p, i) -= lines.at (p, input) * force;
    }
}
} // namespace

ResponseTable::ResponseTable (const ModalModel& model, Eigen::MatrixXd inputsToUse, double sampleRateToUse,
                              Eigen::Index lengthToUse, double highest)
    : inputs (std::move (inputsToUse)), sampleRate (sampleRateToUse), length (lengthToUse)
{
    requireRealModes (model, "waveforms at points");
    const auto spacing = 2 * std::numbers::pi * sampleRate / static_cast<double> (length); // rad/s
    const auto lines = std::min<Eigen::Index> (static_cast<Eigen::Index> (2 * std::numbers::pi * highest / spacing) + 1,
                                               length / 2 + 1);
    const auto& own = model.angularFrequencies;
    const auto resonances = (own.array() < farAbove * 2 * std::numbers::pi * highest).count();
    real.resize (lines, resonances + terms);
    imaginary.resize (lines, resonances + terms);

    for (Eigen::Index line = 0; line < lines; ++line)
    {
        checkWatch();
        const Complex s (0, spacing * static_cast<double> (line));
        Complex power = 1;

        for (Eigen::Index k = 0; k < resonances + terms; ++k)
        {
            const auto value =
                k < resonances ? 1.0 / (own[k] * own[k] + 2 * model.dampingRatios[k] * own[k] * s + s * s) : power;
            power *= k < resonances ? 1.0 : s;
            real (line, k) = value.real();
            imaginary (line, k) = value.imag();
        }
    }

    series.resize (terms, own.size() - resonances);

    for (Eigen::Index k = 0; k < series.cols(); ++k)
        series.col (k) = powerSeries (own[resonances + k], model.dampingRatios[resonances + k]);
}

/** How much of each resonance and of each power is in the motion of a row of shapes, per input. */
Eigen::MatrixXd ResponseTable::strengths (const Eigen::RowVectorXd& shapes, const Eigen::MatrixXd& allInputs) const
{
    const auto above = series.cols(), resonances = shapes.size() - above;
    Eigen::MatrixXd result (resonances + terms, allInputs.cols());
    result.topRows (resonances) = shapes.head (resonances).asDiagonal() * allInputs.topRows (resonances);
    result.bottomRows (terms).setZero();
    addProduct (result.bottomRows (terms), 1, series * shapes.tail (above).asDiagonal(), allInputs.bottomRows (above));
    return result;
}

PointResponses ResponseTable::responses (const Eigen::MatrixXd& pointShapes,
                                         const std::vector<SurfaceLoad>& loads) const
{
    LoadedLines lines { {}, pointShapes.rows(), inputs.cols(), static_cast<Eigen::Index> (loads.size()) };
    const auto rows = lines.points + lines.loads, columns = lines.actuators + lines.loads;
    Eigen::MatrixXd shapes (rows, inputs.rows()), allInputs (inputs.rows(), columns);
    shapes.topRows (lines.points) = pointShapes;
    allInputs.leftCols (lines.actuators) = inputs;

    for (Eigen::Index f = 0; f < lines.loads; ++f)
    {
        shapes.row (lines.points + f) = loads[static_cast<std::size_t> (f)].shapes;
        allInputs.col (lines.actuators + f) = loads[static_cast<std::size_t> (f)].shapes.transpose();
    }

    Eigen::MatrixXd all (real.cols(), rows * columns);

    for (Eigen::Index p = 0; p < rows; ++p)
        all (Eigen::all, Eigen::seqN (p, columns, rows)) = strengths (shapes.row (p), allInputs);

    Eigen::MatrixXd realPart = Eigen::MatrixXd::Zero (real.rows(), all.cols()), imaginaryPart = realPart;
    addProduct (realPart, 1, real, all);
    addProduct (imaginaryPart, 1, imaginary, all);
    lines.values.resize (real.rows(), all.cols());
    lines.values.real() = realPart;
    lines.values.imag() = imaginaryPart;
    const Eigen::ArrayXd omega = Eigen::ArrayXd::LinSpaced (real.rows(), 0, static_cast<double> (real.rows() - 1))
                                 * (2 * std::numbers::pi * sampleRate / static_cast<double> (length));

    for (Eigen::Index f = 0; f < lines.loads; ++f)
    {
        const auto& load = loads[static_cast<std::size_t> (f)];
        Lines impedance (omega.size());
        impedance.real() = load.stiffness - load.mass * omega.square();
        impedance.imag() = load.damping * omega;
        addLoad (lines, f, impedance);
    }

    PointResponses responses { lines.points, lines.actuators, length, sampleRate, {} };
    responses.values = Eigen::MatrixXcd::Zero (length / 2 + 1, lines.points * lines.actuators);

    for (Eigen::Index i = 0; i < lines.actuators; ++i)
        responses.values.block (0, lines.points * i, real.rows(), lines.points) =
            lines.values.middleCols (rows * i, lines.points);

    return responses;
}
} // namespace antinode
