#include "LimitedAllocation.h"

#include "AllocationInteriorPoint.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace antinode
{
namespace
{
/** What rounding may have added to a bound. */
constexpr auto roundingAllowance = 1e-12;

double price (const WhitenedAllocation& problem, const Eigen::MatrixXd& sampleMultipliers)
{
    return sampleMultipliers.cwiseAbs().colwise().sum().dot (problem.limits);
}
} // namespace

double leastNormBound (const WhitenedAllocation& problem, const RowSystem& rows,
                       const Eigen::MatrixXd& sampleMultipliers, double ratio)
{
    const auto pull = problem.pull (sampleMultipliers);
    const auto y = rows.multipliers (problem.wanted + problem.rowValues (pull));
    const auto shares = (problem.weightedRows (y) - pull).squaredNorm();
    const auto guards = y.cwiseAbs2().dot (problem.compliance);
    return (1 - roundingAllowance)
           * (problem.wanted.dot (y) - 0.5 * (shares + guards) - ratio * price (problem, sampleMultipliers));
}

double minimumPeakBound (const WhitenedAllocation& problem, const Eigen::VectorXd& rowMultipliers,
                         Eigen::MatrixXd sampleMultipliers)
{
    sampleMultipliers += problem.balancing (problem.weightedRows (rowMultipliers) - problem.pull (sampleMultipliers));
    const auto all = price (problem, sampleMultipliers);
    return all > 0 ? (1 - roundingAllowance) * problem.wanted.dot (rowMultipliers) / all : 0;
}

namespace
{
/** Iterations after which a gap that is small enough is taken for the smallest that can be had. */
constexpr auto patience = 60;

constexpr auto maximumIterations = 400;

Eigen::VectorXd peaks (const Eigen::MatrixXd& voltages)
{
    return voltages.cwiseAbs().colwise().maxCoeff().transpose();
}

double peakRatio (const Eigen::MatrixXd& voltages, const Eigen::VectorXd& limits)
{
    return peaks (voltages).cwiseQuotient (limits).maxCoeff();
}

/** The interior point method with constraint generation: every peak beyond its limit joins the working set at once. */
class PeakSearch
{
public:
    PeakSearch (const WhitenedAllocation& problemToUse, const RowSystem& rowsToUse, AllocationInteriorPoint::Ratio kind,
                double ratio, double curvature, const Eigen::MatrixXd& start)
        : problem (problemToUse), rows (rowsToUse), currentShares (start), currentVoltages (problem.voltages (start)),
          method (problem, kind, ratio, curvature, start)
    {
    }

    /** Limits the peaks above a threshold each, where there are any. */
    void limitPeaks (const Eigen::VectorXd& thresholds)
    {
        const auto found = localPeaks (currentVoltages, thresholds);

        if (std::all_of (found.begin(), found.end(), [] (const auto& list) { return list.empty(); }))
            return;

        method.addSamples (found);
        ++work.rounds;
    }

    /** One step, to shares that meet the hard rows.
        @return  false where none is left */
    bool advance()
    {
        if (work.iterations == maximumIterations || ! method.step())
            return false;

        ++work.iterations;
        currentShares = rows.withExactRows (method.shares());
        currentVoltages = problem.voltages (currentShares);
        return true;
    }

    /** Whether a relative gap may stay: the smallest that rounding allows is aimed at, but not at any price. */
    bool isEnough (double gap, double aim, double need) const
    {
        return gap <= (work.iterations < patience ? aim : need);
    }

    const AllocationInteriorPoint& state() const { return method; }
    const AllocationEffort& effort() const { return work; }
    const Eigen::MatrixXd& shares() const { return currentShares; }
    const Eigen::MatrixXd& voltages() const { return currentVoltages; }

private:
    const WhitenedAllocation& problem;
    const RowSystem& rows;
    Eigen::MatrixXd currentShares, currentVoltages;
    AllocationInteriorPoint method;
    AllocationEffort work;
};

/** How a least peak is searched for. */
struct PeakAim
{
    double easyRatio;  ///< A ratio that is low enough.
    double steadiness; ///< Curvature of the steps in parts of the ratio, at shares of the least norm.
};

constexpr auto neededPeakGap = 5e-7;

/** Improves shares and bound as far as it can. */
void searchMinimumPeak (LimitedAllocation& best, const WhitenedAllocation& problem, const RowSystem& rows, PeakAim aim,
                        const ShowAllocationProgress& show)
{
    constexpr auto wantedGap = 1e-7;
    constexpr auto firstPeaks = 0.2;
    constexpr auto room = 1.1;
    const auto start = rows.leastNormShares();
    const auto ratio = problem.peakRatio (start);
    PeakSearch search (problem, rows, AllocationInteriorPoint::Ratio::free, room * ratio,
                       aim.steadiness * ratio / start.squaredNorm(), start);
    search.limitPeaks (firstPeaks * peaks (search.voltages()));

    while (best.value > aim.easyRatio && ! search.isEnough (best.gap(), wantedGap, neededPeakGap) && search.advance())
    {
        report (show,
                { AllocationStage::minimumPeak, best.effort.iterations + search.effort().iterations, best.gap() });
        const auto& state = search.state();
        best.improve (search.shares(), peakRatio (search.voltages(), problem.limits),
                      minimumPeakBound (problem, state.rowMultipliers(), state.sampleMultipliers()));
        search.limitPeaks (state.peakRatio() * problem.limits);
    }

    best.effort.iterations += search.effort().iterations;
    best.effort.rounds += search.effort().rounds;
}

/** Shares pulled towards a point inside the limits until none of their samples is beyond. */
Eigen::MatrixXd pulledInside (const Eigen::MatrixXd& shares, double reached, double allowed,
                              const Eigen::MatrixXd& inside, double insideRatio)
{
    if (reached <= allowed)
        return shares;

    const auto weight = std::min (1.0, (reached - allowed) / (reached - insideRatio));
    return (1 - weight) * shares + weight * inside;
}
/** Where a least norm is searched for. */
struct NormAim
{
    double ratio;      ///< The limits', times their own.
    double firstPeaks; ///< Peaks above this share of the limits are limited from the beginning.
    const Eigen::MatrixXd& inside;
};

/** Improves shares and bound as far as it can. */
void searchLeastNorm (LimitedAllocation& best, const WhitenedAllocation& problem, const NormAim& aim,
                      const RowSystem& rows, const ShowAllocationProgress& show)
{
    constexpr auto wantedGap = 1e-9;
    constexpr auto neededGap = 1e-7;
    const auto insideRatio = problem.peakRatio (aim.inside);
    const Eigen::VectorXd limits = aim.ratio * problem.limits;
    PeakSearch search (problem, rows, AllocationInteriorPoint::Ratio::fixed, aim.ratio, 1, aim.inside);
    search.limitPeaks (aim.firstPeaks * limits);

    while (! search.isEnough (best.gap(), wantedGap, neededGap) && search.advance())
    {
        report (show, { AllocationStage::leastNorm, best.effort.iterations + search.effort().iterations, best.gap() });
        const auto reached = peakRatio (search.voltages(), problem.limits);
        const auto allowed = pulledInside (search.shares(), reached, aim.ratio, aim.inside, insideRatio);
        best.improve (allowed, problem.objective (allowed),
                      leastNormBound (problem, rows, search.state().sampleMultipliers(), aim.ratio));
        search.limitPeaks (limits);
    }

    best.effort.iterations += search.effort().iterations;
    best.effort.rounds += search.effort().rounds;
}
} // namespace

LimitedAllocation minimumPeakShares (const WhitenedAllocation& problem, const RowSystem& rows, double easyRatio,
                                     const ShowAllocationProgress& show)
{
    LimitedAllocation best;
    best.shares = rows.leastNormShares();
    best.value = problem.peakRatio (best.shares);

    // The steadiness that helps one problem slows another down: if rounding ends the search too early, it restarts.
    for (const auto steadiness : { 1e-3, 1e-5, 1e-1 })
        if (best.value > easyRatio && best.gap() > neededPeakGap)
            searchMinimumPeak (best, problem, rows, { easyRatio, steadiness }, show);

    return best;
}

LimitedAllocation leastNormShares (const WhitenedAllocation& problem, const RowSystem& rows, double ratio,
                                   const Eigen::MatrixXd& inside, const ShowAllocationProgress& show)
{
    constexpr auto acceptedGap = 1e-6;
    LimitedAllocation best;
    best.shares = inside;
    best.value = problem.objective (inside);

    // Other first samples are another way there: where rounding ends one too early the next one begins.
    for (const auto firstPeaks : { 0.8, 0.3, 0.95 })
        if (best.effort.rounds == 0 || best.gap() > acceptedGap)
            searchLeastNorm (best, problem, { ratio, firstPeaks, inside }, rows, show);

    return best;
}

double LimitedAllocation::gap() const
{
    return (value - bound) / value;
}

void LimitedAllocation::improve (const Eigen::MatrixXd& newShares, double newValue, double newBound)
{
    bound = std::max (bound, newBound);

    if (newValue < value)
    {
        value = newValue;
        shares = newShares;
    }
}

std::vector<std::vector<Eigen::Index>> localPeaks (const Eigen::MatrixXd& voltages, const Eigen::VectorXd& thresholds)
{
    std::vector<std::vector<Eigen::Index>> lists (static_cast<std::size_t> (voltages.cols()));
    const auto last = voltages.rows() - 1;

    for (Eigen::Index i = 0; i < voltages.cols(); ++i)
    {
        const auto* voltage = voltages.col (i).data();

        for (Eigen::Index n = 0; n <= last; ++n)
        {
            const auto value = std::abs (voltage[n]);

            if (value > thresholds[i] && value >= std::abs (voltage[std::max<Eigen::Index> (n - 1, 0)])
                && value >= std::abs (voltage[std::min (n + 1, last)]))
                lists[static_cast<std::size_t> (i)].push_back (n);
        }
    }

    return lists;
}
} // namespace antinode
