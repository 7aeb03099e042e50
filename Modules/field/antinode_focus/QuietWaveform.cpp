#include "QuietWaveform.h"

#include "FeltElsewhere.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>

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
} // namespace antinode
