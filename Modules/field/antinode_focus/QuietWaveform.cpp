#include "QuietWaveform.h"

#include "FeltElsewhere.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto settledSlope = 1e-3; // of the slope at the start: the sum is then the least to about 1e-6
constexpr int mostSteps = 400;

/** The splines of the least energy of voltages and weight times that of what is felt, by conjugate gradients. */
Eigen::MatrixXd bestSplines (const QuietBasis& basis, const FeltElsewhere& elsewhere, const Eigen::MatrixXd& felt,
                             double weight, LessFelt& effort)
{
    const auto curved = [&] (const Eigen::MatrixXd& s)
    {
        const auto change = basis.allowed (s);
        auto slope = basis.energySlope (change);
        const auto more = elsewhere.slope (weight * elsewhere.ofCorrection (change));
        slope.splines += more.splines;
        slope.rows += more.rows;
        return basis.slopeOf (slope);
    };
    Eigen::MatrixXd missing = -basis.slopeOf (elsewhere.slope (weight * felt));
    Eigen::MatrixXd splines = Eigen::MatrixXd::Zero (missing.rows(), missing.cols());
    auto ready = basis.preconditioned (missing);
    Eigen::MatrixXd direction = ready;
    const auto dot = [] (const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return a.cwiseProduct (b).sum(); };
    auto size = dot (missing, ready);
    const auto first = size;

    for (effort.iterations = 0; effort.iterations < mostSteps && size > settledSlope * settledSlope * first;
         ++effort.iterations)
    {
        checkWatch();
        const auto bent = curved (direction);
        const auto step = size / dot (direction, bent);
        splines += step * direction;
        missing -= step * bent;
        ready = basis.preconditioned (missing);
        const auto next = dot (missing, ready);
        direction = ready + (next / size) * direction;
        size = next;
    }

    effort.residual = first > 0 ? std::sqrt (size / first) : 0;
    return splines;
}

/** How much of a change the limits allow, 0 to 1. */
double allowedShare (const Eigen::MatrixXd& samples, const Eigen::MatrixXd& change, const Eigen::VectorXd& limits)
{
    double share = 1;

    for (Eigen::Index n = 0; n < samples.cols(); ++n)
        for (Eigen::Index i = 0; i < samples.rows(); ++i)
        {
            const auto room = limits[i] - (change (i, n) > 0 ? samples (i, n) : -samples (i, n));

            if (std::abs (change (i, n)) * share > room)
                share = std::max (room, 0.0) / std::abs (change (i, n));
        }

    return share;
}

/** Adds the change that is best at the wanted weight, or at half of it and so on until limits are kept. Where none of
   these keeps them, as much as they allow. */
void addBestChange (Eigen::MatrixXd& samples, LessFelt& result, const QuietTask& task, const QuietBasis& basis,
                    const FeltElsewhere& elsewhere, double sampleRate)
{
    constexpr int halvings = 10;
    const auto felt = elsewhere.ofSamples (samples, sampleRate);
    const auto energy = (samples.leftCols (task.range.count).cwiseAbs2() * task.problem.costs).sum();

    if (! (felt.squaredNorm() > 0) || result.weight == 0)
        return;

    for (int i = 0; i <= halvings; ++i, result.weight /= 2)
    {
        const auto weight = result.weight * energy / felt.squaredNorm();
        const auto change = basis.allowed (bestSplines (basis, elsewhere, felt, weight, result));
        const auto voltages = basis.voltages (change);
        result.share = allowedShare (samples, voltages, task.problem.limits);

        if (result.share < 1 && i < halvings)
            continue;

        samples += result.share * voltages;
        const Eigen::MatrixXd left = felt + result.share * elsewhere.ofCorrection (change);
        result.gain = 10 * std::log10 (felt.squaredNorm() / left.squaredNorm());
        return;
    }
}

/** max |row error| / max |wanted| of the hard rows. */
double hardResidual (const BoundedWaveformProblem& problem, const Eigen::VectorXd& values)
{
    const Eigen::VectorXd errors =
        (problem.compliance.array() == 0).select (values - problem.wanted, Eigen::VectorXd::Zero (values.size()));
    return errors.cwiseAbs().maxCoeff() / problem.wanted.cwiseAbs().maxCoeff();
}
} // namespace

void makeQuieter (FreeWaveform& waveform, const QuietTask& task)
{
    const auto& choice = task.description.felt.value();
    const auto playback = waveform.voltages.playback;
    auto& samples = waveform.voltages.values;
    const auto before = samples.cols();
    const auto length =
        std::max (before, task.range.focus + 1 + static_cast<Eigen::Index> (choice.after * playback.sampleRate));
    samples.conservativeResize (Eigen::NoChange, length);
    samples.rightCols (length - before).setZero();

    const QuietBasis basis (task, playback, length);
    const auto lines = feltLines (task.model, task.description, static_cast<double> (length) / playback.sampleRate);
    const FeltElsewhere elsewhere (lines, basis, task.problem.participation, playback.sampleRate);
    waveform.felt = LessFelt {};
    waveform.felt->plainPeak = samples.cwiseAbs().maxCoeff();
    waveform.felt->weight = choice.weight;

    if (basis.size() > 0)
        addBestChange (samples, *waveform.felt, task, basis, elsewhere, playback.sampleRate);

    auto& certificate = waveform.certificate;
    certificate.peakRatio = samples.cwiseAbs().rowwise().maxCoeff().cwiseQuotient (task.problem.limits).maxCoeff();
    certificate.rowResidual = hardResidual (task.problem, basis.rowValues (samples));
}

namespace
{
constexpr double knotsPerSecond = 4000; // of the splines that a correction consists of: to about 1 kHz
constexpr auto guardStiffening = 1e4;   // of guards against changes: less felt elsewhere is to leave the field as it is

double cubicSpline (double knots)
{
    const auto distance = std::abs (knots);

    if (distance < 1)
        return 2.0 / 3 - distance * distance * (1 - 0.5 * distance);

    return distance < 2 ? std::pow (2 - distance, 3) / 6 : 0;
}

/** Cubic B-splines that begin and end within so many samples, one a row. A knot is at the focus, and the two beside it
   count as one: so no sum of them has a slope there, which all stiff modes would follow. */
Eigen::MatrixXd sampledSplines (Eigen::Index samples, Eigen::Index focus, double sampleRate)
{
    constexpr double reach = 2; // knots
    const auto perKnot = sampleRate / knotsPerSecond;
    const auto place = [&] (Eigen::Index n) { return static_cast<double> (n - focus) / perKnot; };
    const auto first = static_cast<int> (std::ceil (place (0) + reach));
    const auto last = static_cast<int> (std::floor (place (samples - 1) - reach));
    std::vector<int> centres;

    for (auto centre = first; centre <= last; ++centre)
        if (centre != 1)
            centres.push_back (centre);

    Eigen::MatrixXd splines (centres.size(), samples);

    for (Eigen::Index n = 0; n < samples; ++n)
        for (Eigen::Index m = 0; m < splines.rows(); ++m)
        {
            const auto centre = centres[static_cast<std::size_t> (m)];
            splines (m, n) = cubicSpline (place (n) - centre) + (centre == -1 ? cubicSpline (place (n) - 1) : 0);
        }

    return splines;
}
} // namespace

QuietBasis::QuietBasis (const QuietTask& task, Playback playback, Eigen::Index samples)
    : participation (task.problem.participation), costs (task.problem.costs), range (task.range),
      splines (sampledSplines (samples, task.range.focus, playback.sampleRate))
{
    const auto count = task.problem.weights.rows();
    const std::vector<int> modes (task.modes.begin(), task.modes.begin() + count);
    rowWaves = task.problem.weights * costs.cwiseInverse().asDiagonal();
    gram = Eigen::MatrixXd::Zero (count, count);
    addTransposedRight (gram, 1, task.problem.weights, rowWaves);
    Eigen::MatrixXd overlaps = Eigen::MatrixXd::Zero (count, count);
    addTransposedRight (overlaps, 1, participation, participation);
    gram = gram.cwiseProduct (overlaps);
    gram.diagonal() += task.problem.compliance / guardStiffening;
    scale = (gram.diagonal().array() > 0).select (gram.diagonal().cwiseSqrt().cwiseInverse(), 0.0);
    factor = scale.asDiagonal() * gram * scale.asDiagonal();
    factor.diagonal() = (scale.array() > 0).select (factor.diagonal().array() + rounding, 1.0);
    factorLower (factor);
    const auto seen = range.count + range.mirrored;
    plainWeights = plainVelocityWeights (task.model, modes, playback, range);
    plainRows = Eigen::MatrixXd::Zero (count, splines.rows());
    addTransposedRight (plainRows, 1, plainWeights, splines.leftCols (seen));
    foldedRows = Eigen::MatrixXd::Zero (count, splines.rows());
    addTransposedRight (foldedRows, 1, task.problem.weights, splines.leftCols (range.count));
    Eigen::VectorXd allCosts = Eigen::VectorXd::Ones (samples);
    allCosts.head (range.count) = costs;
    energy = Eigen::MatrixXd::Zero (splines.rows(), splines.rows());
    addTransposedRight (energy, 1, splines * allCosts.asDiagonal(), splines);
    energyFactor = energy;
    factorLower (energyFactor);
}

QuietCorrection QuietBasis::allowed (Eigen::MatrixXd s) const
{
    auto rows = restored (valuesOf (plainRows, s));
    return { std::move (s), std::move (rows) };
}

Eigen::MatrixXd QuietBasis::slopeOf (const QuietCorrection& slope) const
{
    return slope.splines + pullOf (plainRows, restored (slope.rows));
}

QuietCorrection QuietBasis::energySlope (const QuietCorrection& change) const
{
    QuietCorrection slope { -pullOf (foldedRows, change.rows),
                            gram * change.rows - valuesOf (foldedRows, change.splines) };
    addProduct (slope.splines, 1, change.splines, energy);
    return slope;
}

Eigen::MatrixXd QuietBasis::preconditioned (const Eigen::MatrixXd& slope) const
{
    return solveFactored (energyFactor, slope.transpose()).transpose();
}

Eigen::MatrixXd QuietBasis::voltages (const QuietCorrection& change) const
{
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero (change.splines.rows(), splines.cols());
    addProduct (all, 1, change.splines, splines);
    Eigen::MatrixXd taken = Eigen::MatrixXd::Zero (all.rows(), range.count);
    addTransposedLeft (taken, 1, change.rows.asDiagonal() * participation, rowWaves);
    const auto mirrored = withMirrorImage (taken, range);
    all.leftCols (mirrored.cols()) -= mirrored;
    return all;
}

Eigen::VectorXd QuietBasis::rowValues (const Eigen::MatrixXd& samples) const
{
    return valuesOf (plainWeights, samples.leftCols (plainWeights.cols()));
}

Eigen::VectorXd QuietBasis::valuesOf (const Eigen::MatrixXd& weights, const Eigen::MatrixXd& waves) const
{
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero (weights.rows(), waves.rows());
    addTransposedRight (values, 1, weights, waves);
    return values.cwiseProduct (participation).rowwise().sum();
}

Eigen::MatrixXd QuietBasis::pullOf (const Eigen::MatrixXd& weights, const Eigen::VectorXd& multipliers) const
{
    Eigen::MatrixXd pull = Eigen::MatrixXd::Zero (participation.cols(), weights.cols());
    addTransposedLeft (pull, 1, multipliers.asDiagonal() * participation, weights);
    return pull;
}

Eigen::VectorXd QuietBasis::restored (const Eigen::VectorXd& values) const
{
    constexpr auto refinements = 2;
    Eigen::VectorXd multipliers = Eigen::VectorXd::Zero (values.size());

    for (int i = 0; i <= refinements; ++i)
        multipliers +=
            scale.cwiseProduct (solveFactored (factor, scale.cwiseProduct (values - gram * multipliers)).col (0));

    return multipliers;
}
} // namespace antinode
