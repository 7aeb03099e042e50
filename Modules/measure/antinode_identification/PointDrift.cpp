#include "PointDrift.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/Statistics.h>

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;

/** Neighbouring modes, first to last. */
struct Group
{
    Eigen::Index first = 0, last = 0;
};

/** The lines around a group, and frequencies in half widths from its middle. */
struct Surroundings
{
    double middle = 0, halfWidth = 0; ///< rad/s
    Eigen::Index firstLine = 0;
    Eigen::VectorXd offsets; ///< N
};

/** One mode whose resonance differs from point to point, in half widths of the surroundings. */
struct DriftingMode
{
    double damping = 1;
    Eigen::VectorXd shifts;    ///< N_p
    Eigen::MatrixXcd residues; ///< N_p x N_b; 0 where not measured.
    double error = 0;          ///< Sum of squares over the degrees of freedom.
};

double halfWidthOf (const IdentifiedModes& modes, Eigen::Index k)
{
    return modes.dampingRatios[k] * modes.angularFrequencies[k];
}

/** Whether references distinguish the two: copies of a mode that points see differently have one participation. */
bool haveOneParticipation (const IdentifiedModes& modes, Eigen::Index k, Eigen::Index l)
{
    constexpr double same = 0.9;
    const auto one = modes.participation.row (k), other = modes.participation.row (l);
    return std::pow (one.dot (other), 2) > same * one.squaredNorm() * other.squaredNorm();
}

std::vector<Group> groupsOf (const IdentifiedModes& modes)
{
    constexpr double reach = 3; // half-power widths
    std::vector<Group> groups;

    for (Eigen::Index k = 0; k + 1 < modes.modes(); ++k)
    {
        const auto distance = modes.angularFrequencies[k + 1] - modes.angularFrequencies[k];
        const auto width = halfWidthOf (modes, k) + halfWidthOf (modes, k + 1);

        if (distance > reach * width || ! haveOneParticipation (modes, k, k + 1))
            continue;

        if (! groups.empty() && groups.back().last == k)
            groups.back().last = k + 1;
        else
            groups.push_back ({ k, k + 1 });
    }

    return groups;
}

/** As far as some half widths beyond the group, and not near to other modes. */
std::optional<Surroundings> surroundingsOf (const FrequencyResponses& responses, const IdentifiedModes& modes,
                                            const Group& group)
{
    constexpr double beyond = 16, share = 0.7;
    constexpr Eigen::Index fewest = 12;
    const auto& omega = modes.angularFrequencies;
    std::vector<double> widths;

    for (auto k = group.first; k <= group.last; ++k)
        widths.push_back (halfWidthOf (modes, k));

    Surroundings result { (omega[group.first] + omega[group.last]) / 2, median (widths), 0, {} };
    auto lowest = omega[group.first] - beyond * result.halfWidth,
         highest = omega[group.last] + beyond * result.halfWidth;

    if (group.first > 0)
        lowest = std::max (lowest, omega[group.first] - share * (omega[group.first] - omega[group.first - 1]));

    if (group.last + 1 < modes.modes())
        highest = std::min (highest, omega[group.last] + share * (omega[group.last + 1] - omega[group.last]));

    const Eigen::VectorXd lines = 2 * std::numbers::pi * responses.frequencies;
    const auto* const begin = lines.data();
    result.firstLine = std::lower_bound (begin, begin + lines.size(), lowest) - begin;
    const auto count = std::upper_bound (begin, begin + lines.size(), highest) - begin - result.firstLine;

    if (count < fewest)
        return {};

    result.offsets = (lines.segment (result.firstLine, count).array() - result.middle) / result.halfWidth;
    return result;
}

/** A resonance at these offsets: 1 / (damping + i (u - shift)). */
Eigen::VectorXcd resonance (const Surroundings& around, double shift, double damping)
{
    return (damping + Complex (0, 1) * (around.offsets.array() - shift)).inverse().matrix();
}

/** Resonances, behind what other modes and residual terms give there. */
Eigen::MatrixXcd withBackground (const Surroundings& around, const std::vector<Eigen::VectorXcd>& resonances)
{
    constexpr Eigen::Index powers = 3;
    const auto count = static_cast<Eigen::Index> (resonances.size());
    Eigen::MatrixXcd functions (around.offsets.size(), count + powers);
    const Eigen::ArrayXd scaled = around.offsets.array() / around.offsets.cwiseAbs().maxCoeff();

    for (Eigen::Index n = 0; n < count; ++n)
        functions.col (n) = resonances[static_cast<std::size_t> (n)];

    for (Eigen::Index n = 0; n < powers; ++n)
        functions.col (count + n) = scaled.pow (static_cast<double> (n)).cast<Complex>();

    return functions;
}

/** The responses of a point to all references on the lines of the surroundings; those that are not complete there are
   0. */
Eigen::MatrixXcd valuesAt (const FrequencyResponses& responses, const Surroundings& around, Eigen::Index point)
{
    Eigen::MatrixXcd values (around.offsets.size(), responses.references.size());

    for (Eigen::Index i = 0; i < values.cols(); ++i)
    {
        values.col (i) =
            responses.values[static_cast<std::size_t> (i)].col (point).segment (around.firstLine, values.rows());

        if (! values.col (i).allFinite())
            values.col (i).setZero();
    }

    return values;
}

/** What all poles of the group leave with free residues, over the degrees of freedom. */
double errorOfGroup (const FrequencyResponses& responses, const IdentifiedModes& modes, const Group& group,
                     const Surroundings& around)
{
    std::vector<Eigen::VectorXcd> resonances;

    for (auto k = group.first; k <= group.last; ++k)
        resonances.push_back (resonance (around, (modes.angularFrequencies[k] - around.middle) / around.halfWidth,
                                         halfWidthOf (modes, k) / around.halfWidth));

    const auto functions = withBackground (around, resonances);
    const Eigen::HouseholderQR<Eigen::MatrixXcd> decomposed (functions);
    double sum = 0;

    for (Eigen::Index p = 0; p < responses.points.rows(); ++p)
    {
        checkWatch();
        const Eigen::MatrixXcd turned = decomposed.householderQ().adjoint() * valuesAt (responses, around, p);
        sum += turned.bottomRows (turned.rows() - functions.cols()).squaredNorm();
    }

    return sum / std::max (1.0, static_cast<double> (functions.rows() - functions.cols()));
}

/** What a step of the common damping would change, summed over points. */
struct DampingStep
{
    double gradient = 0, curvature = 0, error = 0;
};

/** Fits the residues of a point and, by one step of Gauss and Newton, its shift. */
void fitPoint (DriftingMode& mode, DampingStep& step, const Surroundings& around, const Eigen::MatrixXcd& values,
               Eigen::Index point)
{
    const auto function = resonance (around, mode.shifts[point], mode.damping);
    const Eigen::HouseholderQR<Eigen::MatrixXcd> decomposed (withBackground (around, { function }));
    constexpr Eigen::Index linear = 4;
    const auto others = values.rows() - linear;
    const auto project = [&] (const Eigen::MatrixXcd& of) -> Eigen::MatrixXcd
    { return (decomposed.householderQ().adjoint() * of).bottomRows (others); };
    const Eigen::MatrixXcd coefficients = decomposed.solve (values);
    const Eigen::MatrixXcd errors = project (values);
    const Eigen::VectorXcd square = project (function.cwiseProduct (function));
    mode.residues.row (point) = coefficients.row (0);
    const auto strength = coefficients.row (0).squaredNorm() * square.squaredNorm();
    // Sum over references of conj (r) <square, e>.
    const auto common = (coefficients.row (0).conjugate() * (square.adjoint() * errors).transpose()).value();
    step.error += errors.squaredNorm();
    step.curvature += strength;
    step.gradient -= common.real();

    if (strength > 0)
        mode.shifts[point] += std::clamp ((Complex (0, -1) * common).real() / strength, -1.0, 1.0);
}

/** The pole of a group that suits a point best. */
double bestShift (const IdentifiedModes& modes, const Group& group, const Surroundings& around,
                  const Eigen::MatrixXcd& values)
{
    auto best = 0.0, least = std::numeric_limits<double>::infinity();

    for (auto k = group.first; k <= group.last; ++k)
    {
        const auto shift = (modes.angularFrequencies[k] - around.middle) / around.halfWidth;
        const auto functions = withBackground (around, { resonance (around, shift, 1) });
        const Eigen::MatrixXcd turned =
            Eigen::HouseholderQR<Eigen::MatrixXcd> (functions).householderQ().adjoint() * values;

        if (const auto error = turned.bottomRows (turned.rows() - functions.cols()).squaredNorm(); error < least)
        {
            least = error;
            best = shift;
        }
    }

    return best;
}

DriftingMode fitDriftingMode (const FrequencyResponses& responses, const IdentifiedModes& modes, const Group& group,
                              const Surroundings& around)
{
    constexpr int sweeps = 30;
    const auto points = responses.points.rows();
    DriftingMode mode { 1, Eigen::VectorXd (points), Eigen::MatrixXcd (points, responses.references.size()), 0 };
    std::vector<Eigen::MatrixXcd> values;

    for (Eigen::Index p = 0; p < points; ++p)
    {
        values.push_back (valuesAt (responses, around, p));
        mode.shifts[p] = bestShift (modes, group, around, values.back());
    }

    for (int sweep = 0; sweep < sweeps; ++sweep)
    {
        checkWatch();
        DampingStep step;

        for (Eigen::Index p = 0; p < points; ++p)
            fitPoint (mode, step, around, values[static_cast<std::size_t> (p)], p);

        mode.error = step.error;

        if (step.curvature > 0)
            mode.damping =
                std::clamp (mode.damping + std::clamp (step.gradient / step.curvature, -0.5, 0.5), 0.02, 50.0);
    }

    // A shift for each point, one of four linear functions for each response.
    const auto freedom =
        static_cast<double> (around.offsets.size()) - 4 - 0.5 / static_cast<double> (responses.references.size());
    mode.error /= std::max (1.0, freedom);
    return mode;
}

/** The shift at which the mode counts: the mean, each point with its energy. */
double meanShift (const DriftingMode& mode)
{
    const Eigen::VectorXd energies = mode.residues.rowwise().squaredNorm();
    return mode.shifts.dot (energies) / std::max (energies.sum(), 1e-300);
}

/** Responses with one resonance in the place of those of the points. */
void straighten (FrequencyResponses& responses, const DriftingMode& mode, const Surroundings& around)
{
    const Eigen::ArrayXd omega = 2 * std::numbers::pi * responses.frequencies.array();
    const auto decay = mode.damping * around.halfWidth;
    const auto function = [&] (double shift) -> Eigen::ArrayXcd
    {
        const auto damped = around.middle + shift * around.halfWidth;
        const Eigen::ArrayXcd derivative = Complex (0, 1) * omega;
        return 2 * around.halfWidth * derivative
               / (derivative.square() + 2 * decay * derivative + (decay * decay + damped * damped));
    };
    const auto common = function (meanShift (mode));

    for (Eigen::Index p = 0; p < responses.points.rows(); ++p)
    {
        checkWatch();
        const Eigen::ArrayXcd change = common - function (mode.shifts[p]);

        for (std::size_t i = 0; i < responses.values.size(); ++i)
            responses.values[i].col (p).array() += mode.residues (p, static_cast<Eigen::Index> (i)) * change;
    }
}

/** How far the resonances of points are apart, relative, and whether they follow the order of the points. */
struct Spread
{
    double range = 0; ///< With the sign of the last point less the first where they follow the order.
    bool isOrdered = false;
};

/** Of the points that show the mode. */
Spread spreadOf (const DriftingMode& mode, const Surroundings& around)
{
    constexpr double visible = 0.05, ordered = 0.8;
    const Eigen::VectorXd strengths = mode.residues.rowwise().norm();
    double count = 0, meanX = 0, meanY = 0;
    const auto isVisible = [&] (Eigen::Index p) { return strengths[p] > visible * strengths.maxCoeff(); };
    const auto points = strengths.size();
    auto least = std::numeric_limits<double>::infinity(), most = -least;

    for (Eigen::Index p = 0; p < points; ++p)
        if (isVisible (p))
        {
            ++count;
            meanX += static_cast<double> (p);
            meanY += mode.shifts[p];
            least = std::min (least, mode.shifts[p]);
            most = std::max (most, mode.shifts[p]);
        }

    meanX /= count;
    meanY /= count;
    double sumXX = 0, sumXY = 0, sumYY = 0;

    for (Eigen::Index p = 0; p < points; ++p)
        if (isVisible (p))
        {
            const auto x = static_cast<double> (p) - meanX, y = mode.shifts[p] - meanY;
            sumXX += x * x;
            sumXY += x * y;
            sumYY += y * y;
        }

    const auto toRelative = around.halfWidth / around.middle;
    const auto isOrdered = count > 2 && sumXY * sumXY > ordered * sumXX * sumYY;
    return { toRelative * (isOrdered ? sumXY / sumXX * static_cast<double> (points - 1) : most - least), isOrdered };
}

std::string describe (const std::vector<double>& frequencies, const std::vector<Spread>& spreads)
{
    std::string list;
    std::vector<double> ranges;
    auto areOrdered = true;

    for (std::size_t n = 0; n < spreads.size(); ++n)
    {
        list += (n == 0 ? "" : n + 1 < spreads.size() ? ", " : " and ") + inWords (frequencies[n]);
        areOrdered = areOrdered && spreads[n].isOrdered && spreads[n].range * spreads[0].range > 0;
        ranges.push_back (spreads[n].range);
    }

    const auto range = micro * median (ranges);
    const auto size = fixedText (std::abs (range), std::abs (range) < 10 ? 1 : 0) + " ppm";
    return "the frequency of the mode at " + list + " Hz "
           + (areOrdered ? (range > 0 ? "rises by " : "falls by ") + size + " from the first to the last point"
                         : "differs by " + size + " from point to point")
           + ": it drifted while points were measured one after the other, or the sensor loads the surface; "
             "poles near it are taken as one mode at the mean";
}
} // namespace

std::optional<PointDrift> findPointDrift (const FrequencyResponses& responses, const IdentifiedModes& modes)
{
    constexpr double same = 1.25; // of the error of all poles of a group
    std::optional<PointDrift> result;
    std::vector<double> frequencies;
    std::vector<Spread> spreads;
    const auto consider = [&] (const Group& group, double most)
    {
        const auto around = surroundingsOf (responses, modes, group);

        if (! around)
            return;

        const auto mode = fitDriftingMode (responses, modes, group, *around);

        if (mode.error > most * errorOfGroup (responses, modes, group, *around))
            return;

        if (! result)
            result = { responses, {} };

        straighten (result->responses, mode, *around);
        frequencies.push_back (around->middle / (2 * std::numbers::pi));
        spreads.push_back (spreadOf (mode, *around));
    };
    const auto groups = responses.points.rows() > 1 ? groupsOf (modes) : std::vector<Group>();

    for (const auto& group : groups)
        consider (group, same);

    // Where some modes drift, those that are not split drift, too.
    for (Eigen::Index k = 0; result && k < modes.modes(); ++k)
        if (std::none_of (groups.begin(), groups.end(),
                          [k] (const Group& group) { return k >= group.first && k <= group.last; }))
            consider ({ k, k }, 1 / same);

    if (result)
        result->said = describe (frequencies, spreads);

    return result;
}
} // namespace antinode
