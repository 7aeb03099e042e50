#include "WaveformBound.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>

namespace antinode
{
namespace
{
void check (bool isRight, const std::string& wrong)
{
    if (! isRight)
        throw InputError ("lower bound", wrong);
}

void validate (const WaveformBoundProblem& problem)
{
    const auto modes = problem.wanted.size();
    const auto ceramics = problem.voltageLimits.size();
    check (modes > 0 && ceramics > 0, "needs at least one mode and one ceramic");
    check (problem.poles.size() == modes && problem.participation.rows() == modes
               && problem.participation.cols() == ceramics,
           "poles, participations, wanted velocities and voltage limits do not agree in size");
    check (problem.poles.allFinite() && problem.participation.allFinite() && problem.wanted.allFinite()
               && problem.voltageLimits.allFinite(),
           "contains a value that is not finite");
    check (problem.poles.real().maxCoeff() <= 0 && problem.poles.imag().minCoeff() > 0,
           "has a pole that grows or does not oscillate; allowed: damped oscillations");
    check (problem.voltageLimits.minCoeff() > 0, "has a voltage limit of 0 V or less; allowed: above 0 V");
    check (std::isfinite (problem.duration) && problem.duration > 0, "has no duration; allowed: above 0 s");

    for (Eigen::Index k = 0; k < modes; ++k)
        check (problem.wanted[k] == 0 || ! problem.participation.row (k).isZero (0),
               "no ceramic excites controlled mode row " + std::to_string (k + 1) + " (counted from 1)");
}

/** What multipliers prove for waveforms of any form. */
double certifiedBound (const WaveformBoundProblem& problem, const Eigen::VectorXd& y, double about)
{
    constexpr auto rounding = 64 * std::numeric_limits<double>::epsilon();
    const auto value = problem.wanted.dot (y) - rounding * problem.wanted.cwiseAbs().dot (y.cwiseAbs());
    return value > 0 ? value / waveformPrice (problem, y, about) : 0;
}
void improve (WaveformBound& bound, const WaveformBoundProblem& problem, const MinimumPeak& peak,
              const HeldCells& cells)
{
    const auto price = peak.lower > 0 ? problem.wanted.dot (peak.multipliers) / peak.lower : 0;
    bound.lower = std::max (bound.lower, certifiedBound (problem, peak.multipliers, price));

    if (peak.upper < bound.upper)
    {
        bound.upper = peak.upper;
        bound.waveforms = cells.waveforms (peak.samples);
    }

    bound.gap = std::isfinite (bound.upper) ? std::max (0.0, 1 - bound.lower / bound.upper) : 1;
}
} // namespace

WaveformBound anyWaveformPeakBound (const WaveformBoundProblem& problem)
{
    constexpr auto maximumRounds = 12;
    constexpr auto firstTolerance = 0.08, laterTolerance = 0.3 * waveformBoundTolerance;
    validate (problem);

    if (problem.wanted.isZero (0))
        return {};

    HeldCells cells (problem);
    WaveformBound bound;
    bound.upper = std::numeric_limits<double>::infinity();
    MinimumPeak peak;
    auto tolerance = firstTolerance, lostPart = laterTolerance;

    for (int round = 0; round < maximumRounds; ++round)
    {
        peak = minimumPeak (cells.problem(), tolerance, round > 0 ? &peak : nullptr);
        improve (bound, problem, peak, cells);

        if (bound.gap <= waveformBoundTolerance || ! std::isfinite (bound.upper))
            break;

        if (! cells.split (peak, lostPart) && tolerance <= laterTolerance)
            lostPart *= 0.5;

        tolerance = std::min (laterTolerance, lostPart);
    }

    return bound;
}

namespace
{
constexpr auto maximumWeights = 128.0 * 1024 * 1024; // 1 GiB
constexpr auto fewestCells = 32.0;
constexpr auto maximumPieces = 8;

/** 1/s: the fastest of the modes that ring at tau. */
double rateAt (const Eigen::VectorXcd& poles, double tau)
{
    constexpr auto decayed = 1e-3;
    double rate = 0;

    for (const auto& pole : poles)
        if (std::exp (pole.real() * tau) > decayed)
            rate = std::max (rate, std::abs (pole));

    return rate;
}

Eigen::VectorXd firstEdges (const WaveformBoundProblem& problem, double maximumCells)
{
    constexpr auto cellsPerCycle = 6.0;
    auto radians = 2 * std::numbers::pi / cellsPerCycle;

    for (;; radians *= 2)
    {
        std::vector<double> edges { 0 };

        while (edges.back() < problem.duration && static_cast<double> (edges.size()) < maximumCells)
        {
            checkWatch();
            const auto rate = rateAt (problem.poles, edges.back());
            const auto widest = problem.duration / fewestCells;
            edges.push_back (edges.back() + (rate * widest > radians ? radians / rate : widest));
        }

        if (edges.back() < problem.duration && static_cast<double> (edges.size()) >= maximumCells)
            continue;

        // The last cell, cut off at the end, is as long as the others.
        const Eigen::Map<const Eigen::VectorXd> all (edges.data(), static_cast<Eigen::Index> (edges.size()));
        Eigen::VectorXd result = all * (problem.duration / edges.back());
        result[result.size() - 1] = problem.duration;
        return result;
    }
}

/** h_k at the edges, N_k x (N_n + 1). */
Eigen::MatrixXd responsesAt (const Eigen::VectorXcd& poles, const Eigen::VectorXd& edges)
{
    Eigen::MatrixXd values (poles.size(), edges.size());

    for (Eigen::Index n = 0; n < edges.size(); ++n)
    {
        checkWatch();

        for (Eigen::Index k = 0; k < poles.size(); ++k)
        {
            const auto angle = poles[k].imag() * edges[n];
            values (k, n) = std::exp (poles[k].real() * edges[n])
                            * (std::cos (angle) + poles[k].real() / poles[k].imag() * std::sin (angle));
        }
    }

    return values;
}

/** integral |q| - |integral q| over a cell of width 1, q the parabola with these values at its ends and this mean; 0
   where q keeps its sign. */
double signLoss (double left, double right, double mean)
{
    constexpr int parts = 8;
    const auto bend = 3 * (left + right - 2 * mean); // q = left + (right - left) x - bend x (1 - x)
    auto before = left, sum = 0.0;
    auto changes = false;

    for (int n = 1; n <= parts; ++n)
    {
        const auto x = static_cast<double> (n) / parts;
        const auto value = left + (right - left) * x - bend * x * (1 - x);
        const auto size = std::abs (before) + std::abs (value);
        const auto isCrossed = before * value < 0;
        sum += 0.5 * (isCrossed ? (before * before + value * value) / size : size);
        changes = changes || isCrossed;
        before = value;
    }

    return changes ? std::max (0.0, sum / parts - std::abs (mean)) : 0;
}

/** What each cell loses when its voltage cannot follow the sign of what pulls at it. */
Eigen::VectorXd signLosses (const Eigen::VectorXd& pulls, const Eigen::VectorXd& atEdges, const Eigen::VectorXd& edges)
{
    Eigen::VectorXd losses (pulls.size());

    for (Eigen::Index n = 0; n < pulls.size(); ++n)
    {
        const auto width = edges[n + 1] - edges[n];
        losses[n] = width * signLoss (atEdges[n], atEdges[n + 1], pulls[n] / width);
    }

    return losses;
}
} // namespace

HeldCells::HeldCells (const WaveformBoundProblem& problem) : poles (problem.poles), wanted (problem.wanted)
{
    const auto rows = static_cast<double> (problem.participation.size());
    const auto edges = firstEdges (problem, std::max (fewestCells + 2, maximumWeights / (4 * rows)));
    const auto weights = std::make_shared<const Eigen::MatrixXd> (computeWeights (edges));

    for (Eigen::Index i = 0; i < problem.voltageLimits.size(); ++i)
        ceramics.push_back ({ edges, problem.participation.col (i) * problem.voltageLimits[i], weights });
}

Eigen::MatrixXd HeldCells::computeWeights (const Eigen::VectorXd& edges) const
{
    const auto cells = edges.size() - 1;
    Eigen::MatrixXd weights (poles.size(), cells);

    for (Eigen::Index k = 0; k < poles.size(); ++k)
    {
        checkWatch();
        const auto response = [&] (double tau)
        { return std::exp (poles[k].real() * tau) * std::sin (poles[k].imag() * tau) / poles[k].imag(); };
        auto start = response (edges[0]);

        for (Eigen::Index n = 0; n < cells; ++n)
        {
            const auto end = response (edges[n + 1]);
            weights (k, n) = end - start;
            start = end;
        }
    }

    return weights;
}

MinimumPeakProblem HeldCells::problem() const
{
    MinimumPeakProblem result;
    result.wanted = wanted;

    for (const auto& ceramic : ceramics)
        result.ceramics.push_back ({ ceramic.gains, ceramic.weights });

    return result;
}

bool HeldCells::split (MinimumPeak& peak, double part)
{
    std::vector<Eigen::VectorXd> losses;
    Eigen::MatrixXd responses;
    double price = 0, lost = 0, losers = 0, cells = 0;

    for (std::size_t i = 0; i < ceramics.size(); ++i)
    {
        checkWatch();
        const auto& ceramic = ceramics[i];
        const Eigen::VectorXd gained = ceramic.gains.cwiseProduct (peak.multipliers);
        const Eigen::VectorXd pulls = ceramic.weights->transpose() * gained;

        if (i == 0 || ceramic.weights != ceramics[i - 1].weights)
            responses = responsesAt (poles, ceramic.edges);

        losses.push_back (signLosses (pulls, responses.transpose() * gained, ceramic.edges));
        price += pulls.cwiseAbs().sum();
        lost += losses.back().sum();
        losers += static_cast<double> ((losses.back().array() > 0).count());
        cells += static_cast<double> (pulls.size());
    }

    const auto worth = 0.3 * part * price / std::max (losers, 1.0);
    const auto pieces = std::clamp (static_cast<int> (std::ceil (std::sqrt (lost / (part * price)))), 2, maximumPieces);

    if (lost < 0.5 * part * price
        || (cells + losers * (pieces - 1)) * static_cast<double> (poles.size()) > maximumWeights)
        return false;

    std::vector<double> samples;
    Eigen::Index first = 0;

    for (std::size_t i = 0; i < ceramics.size(); ++i)
    {
        auto& ceramic = ceramics[i];
        std::vector<double> edges { 0 };

        for (Eigen::Index n = 0; n < losses[i].size(); ++n)
        {
            const auto count = losses[i][n] > worth ? pieces : 1;
            const auto start = ceramic.edges[n], end = ceramic.edges[n + 1];

            for (int piece = 1; piece <= count; ++piece)
            {
                edges.push_back (piece == count ? end : start + (end - start) * piece / count);
                samples.push_back (peak.samples[first + n]);
            }
        }

        first += losses[i].size();
        ceramic.edges = Eigen::Map<const Eigen::VectorXd> (edges.data(), static_cast<Eigen::Index> (edges.size()));
        ceramic.weights = std::make_shared<const Eigen::MatrixXd> (computeWeights (ceramic.edges));
    }

    peak.samples = Eigen::Map<const Eigen::VectorXd> (samples.data(), static_cast<Eigen::Index> (samples.size()));
    return true;
}

std::vector<HeldWaveform> HeldCells::waveforms (const Eigen::VectorXd& samples) const
{
    std::vector<HeldWaveform> result;
    Eigen::Index first = 0;

    for (const auto& ceramic : ceramics)
    {
        const auto cells = ceramic.edges.size() - 1;
        result.push_back ({ ceramic.edges, samples.segment (first, cells) });
        first += cells;
    }

    return result;
}

namespace
{
using Complex = std::complex<double>;
constexpr int terms = 8; // of the polynomials
constexpr Eigen::Index block = 32;
using Polynomial = std::array<double, terms>; // in x = 2 (tau - middle) / step, |x| <= 1

double at (const Polynomial& p, double x)
{
    double value = 0;

    for (int m = terms - 1; m >= 0; --m)
        value = value * x + p[static_cast<std::size_t> (m)];

    return value;
}

/** An upper bound of the integral of |p| over |x| <= 1. */
double absoluteIntegral (const Polynomial& p)
{
    constexpr int parts = 16;
    constexpr auto step = 2.0 / parts;
    double others = 0, curvature = 0, even = 0;

    for (int m = 0; m < terms; ++m)
    {
        const auto size = std::abs (p[static_cast<std::size_t> (m)]);
        others += m > 0 ? size : 0;
        curvature += m * (m - 1) * size;
        even += m % 2 == 0 ? 2 * p[static_cast<std::size_t> (m)] / (m + 1) : 0;
    }

    if (std::abs (p[0]) > others)
        return std::abs (even);

    double sum = 0, left = at (p, -1);

    for (int n = 1; n <= parts; ++n)
    {
        const auto right = at (p, -1 + n * step);
        const auto both = std::abs (left) + std::abs (right);
        sum += left * right >= 0 || both == 0 ? both : (left * left + right * right) / both;
        left = right;
    }

    return step * (0.5 * sum + parts * step * step * curvature / 12);
}

/** What f_i is made of: gains (i, k) Re [weight_k e^{s_k tau}]. */
struct Terms
{
    Eigen::VectorXcd poles, weights;
    Eigen::MatrixXd gains;
    Eigen::VectorXd limits;

    /** sum_i limit_i sum_k |gain weight s^order| e^{-a tau}: never less than what the order-th derivatives sum to from
        tau on. */
    double derivativeBound (double tau, int order) const
    {
        const Eigen::ArrayXd sizes =
            weights.array().abs() * poles.array().abs().pow (order) * (poles.real().array() * tau).exp();
        return limits.dot (gains.cwiseAbs() * sizes.matrix());
    }
};

double factorial (int n)
{
    return std::tgamma (n + 1.0);
}

/** The Taylor coefficients m of all f_i around first + (n + 1/2) step, N_b x block each. */
std::array<Eigen::MatrixXd, terms> taylor (const Terms& sum, double first, double step)
{
    const auto modes = sum.poles.size();
    std::array<Eigen::MatrixXd, terms> result;
    Eigen::MatrixXcd values (modes, block);

    for (Eigen::Index k = 0; k < modes; ++k)
    {
        checkWatch();
        const auto turn = std::exp (sum.poles[k] * step);
        values (k, 0) = sum.weights[k] * std::exp (sum.poles[k] * (first + 0.5 * step));

        for (Eigen::Index n = 1; n < block; ++n)
            values (k, n) = values (k, n - 1) * turn;
    }

    for (int m = 0; m < terms; ++m)
    {
        auto& coefficients = result[static_cast<std::size_t> (m)];
        coefficients = Eigen::MatrixXd::Zero (sum.gains.rows(), block);
        addProduct (coefficients, 1, sum.gains, values.real());
        values = (sum.poles * (0.5 * step / (m + 1))).asDiagonal() * values;
    }

    return result;
}
} // namespace

double waveformPrice (const WaveformBoundProblem& problem, const Eigen::VectorXd& y, double about)
{
    constexpr auto remainderPart = 1e-5, widest = 1.0 / 64;
    constexpr auto rounding = 64 * std::numeric_limits<double>::epsilon();
    const auto& poles = problem.poles;
    const Terms sum { poles, (Complex (0, -1) * poles.array() / poles.imag().array().cast<Complex>()).matrix(),
                      (y.asDiagonal() * problem.participation).transpose(), problem.voltageLimits };
    const auto end = problem.duration;
    const auto allowed = remainderPart * std::max (about / end, rounding * sum.derivativeBound (0, 0));
    double price = 0;

    for (double tau = 0; tau < end;)
    {
        const auto missed = sum.derivativeBound (tau, terms) / factorial (terms); // times (step/2)^8
        const auto fits = missed > 0 ? 2 * std::pow (allowed / missed, 1.0 / terms) : end;
        const auto step = std::min ({ fits, widest * end, (end - tau) / block });
        const auto coefficients = taylor (sum, tau, step);

        checkWatch();

        for (Eigen::Index n = 0; n < block; ++n)
            for (Eigen::Index i = 0; i < problem.voltageLimits.size(); ++i)
            {
                Polynomial p;

                for (std::size_t m = 0; m < terms; ++m)
                    p[m] = coefficients[m](i, n);

                price += 0.5 * step * problem.voltageLimits[i] * absoluteIntegral (p);
            }

        const auto length = step * block;
        price += length * (missed * std::pow (0.5 * step, terms) + rounding * sum.derivativeBound (tau, 0));
        tau = end - tau <= length * (1 + rounding) ? end : tau + length;
    }

    return price;
}
} // namespace antinode
