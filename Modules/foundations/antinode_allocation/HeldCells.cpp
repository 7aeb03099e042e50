#include "HeldCells.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
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
} // namespace antinode
