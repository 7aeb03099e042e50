#include "LowerBound.h"

#include "HeldCells.h"
#include "WaveformPrice.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>
#include <limits>
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
} // namespace antinode
