#include "MinimumPeak.h"

#include "PeakRows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace antinode
{
namespace
{
constexpr auto maximumPeakSteps = 80;

/** s and p strictly inside |s| <= p, multipliers of both limits above 0 with A' y = above - below, their sum 1. */
struct InnerPoint
{
    Eigen::VectorXd y;
    double peak = 0;
    Eigen::ArrayXd s, above, below;

    double complementarity() const { return (above * (peak - s) + below * (peak + s)).sum(); }
};

/** A direction of all unknowns. */
struct InnerStep
{
    Eigen::VectorXd y;
    double peak = 0;
    Eigen::ArrayXd s, above, below;
};

/** An inner point whose complementarity is about the given part of the peak. */
InnerPoint innerPoint (const PeakRows& rows, const Eigen::VectorXd& y, const Eigen::VectorXd& s, double part)
{
    InnerPoint point;
    point.s = s.array();
    point.peak = point.s.abs().maxCoeff() * (1 + part);
    Eigen::ArrayXd pulls = rows.pulls (y).array();
    const auto price = pulls.abs().sum();
    const auto scale = price > 0 ? 1 / (price * (1 + part)) : 0.0;
    const auto even = (price > 0 ? part / (1 + part) : 1.0) / (2.0 * static_cast<double> (s.size()));
    pulls *= scale;
    point.y = scale * y;
    point.above = pulls.max (0) + even;
    point.below = (-pulls).max (0) + even;
    return point;
}

/** The Newton system at a point, factored once for predictor and corrector. */
class NewtonSystem
{
public:
    NewtonSystem (const PeakRows& usedRows, const InnerPoint& usedPoint)
        : rows (usedRows), point (usedPoint), fromAbove (point.peak - point.s), fromBelow (point.peak + point.s),
          ratioAbove (point.above / fromAbove), ratioBelow (point.below / fromBelow),
          inverse ((ratioAbove + ratioBelow).inverse()), lean ((ratioAbove - ratioBelow) * inverse),
          factor (rows.factored (inverse)), border (rows.values (lean.matrix())),
          solvedBorder (rows.solved (factor, border)),
          corner (4 * (ratioAbove * ratioBelow * inverse).sum() + border.dot (solvedBorder)),
          missing (rows.wanted() - rows.values (point.s.matrix()))
    {
    }

    bool isUsable() const { return factor.size() > 0 && std::isfinite (corner) && corner > 0; }

    /** Leads to (peak -+ s) times multiplier = the products now + these. */
    InnerStep towards (const Eigen::ArrayXd& addAbove, const Eigen::ArrayXd& addBelow) const
    {
        const Eigen::ArrayXd overAbove = addAbove / fromAbove, overBelow = addBelow / fromBelow;
        const Eigen::ArrayXd drive = overAbove - overBelow;
        const Eigen::VectorXd right = rows.values ((drive * inverse).matrix()) + missing;
        const auto solved = rows.solved (factor, right);
        InnerStep step;
        step.peak = ((overAbove + overBelow).sum() - (lean * drive).sum() + border.dot (solved)) / corner;
        step.y = solved - step.peak * solvedBorder;
        step.s = (rows.pulls (step.y).array() - drive) * inverse + step.peak * lean;
        step.above = overAbove - ratioAbove * (step.peak - step.s);
        step.below = overBelow - ratioBelow * (step.peak + step.s);
        return step;
    }

private:
    const PeakRows& rows;
    const InnerPoint& point;

public:
    const Eigen::ArrayXd fromAbove, fromBelow;

private:
    const Eigen::ArrayXd ratioAbove, ratioBelow, inverse, lean;
    const Eigen::MatrixXd factor;
    const Eigen::VectorXd border, solvedBorder;
    const double corner;
    const Eigen::VectorXd missing;
};

/** The longest step, at most 1, that leaves values + length change at or above 0. */
double lengthWithin (const Eigen::ArrayXd& values, const Eigen::ArrayXd& change)
{
    const auto steepest = (change / values).minCoeff();
    return steepest < -1 ? -1 / steepest : 1;
}

struct StepLengths
{
    double primal = 1, dual = 1;
};

StepLengths lengthsWithin (const NewtonSystem& system, const InnerPoint& point, const InnerStep& step)
{
    return { std::min (lengthWithin (system.fromAbove, step.peak - step.s),
                       lengthWithin (system.fromBelow, step.peak + step.s)),
             std::min (lengthWithin (point.above, step.above), lengthWithin (point.below, step.below)) };
}

InnerPoint moved (InnerPoint point, const InnerStep& step, StepLengths lengths)
{
    point.s += lengths.primal * step.s;
    point.peak += lengths.primal * step.peak;
    point.y += lengths.dual * step.y;
    point.above += lengths.dual * step.above;
    point.below += lengths.dual * step.below;
    return point;
}

/** One step of predictor and corrector; false where rounding leaves none. */
bool advance (const PeakRows& rows, InnerPoint& point)
{
    constexpr auto kept = 0.05, minimumKept = 0.005, smallest = 1e-6;
    const NewtonSystem system (rows, point);

    if (! system.isUsable())
        return false;

    const Eigen::ArrayXd products = point.above * system.fromAbove, productsBelow = point.below * system.fromBelow;
    const auto now = products.sum() + productsBelow.sum();
    const auto predictor = system.towards (-products, -productsBelow);
    const auto reached = moved (point, predictor, lengthsWithin (system, point, predictor)).complementarity();
    const auto centring = std::pow (std::clamp (reached / now, 0.0, 1.0), 3);
    const auto target = centring * now / (2.0 * static_cast<double> (point.s.size()));
    const auto step = system.towards (target - products - (predictor.peak - predictor.s) * predictor.above,
                                      target - productsBelow - (predictor.peak + predictor.s) * predictor.below);
    auto lengths = lengthsWithin (system, point, step);
    const auto inside = 1 - std::max (minimumKept, std::min (kept, centring));
    lengths = { std::min (1.0, inside * lengths.primal), std::min (1.0, inside * lengths.dual) };
    const auto next = moved (point, step, lengths);

    if (! next.y.allFinite() || ! next.s.allFinite() || ! std::isfinite (next.peak))
        return false;

    point = next;
    return std::max (lengths.primal, lengths.dual) > smallest;
}

void improveDual (const PeakRows& rows, const Eigen::VectorXd& y, MinimumPeak& best)
{
    const auto price = rows.pulls (y).cwiseAbs().sum();
    const auto bound = price > 0 ? rows.wanted().dot (y) / price : 0;

    if (bound > best.lower || best.multipliers.size() == 0)
    {
        best.lower = std::max (0.0, bound);
        best.multipliers = y;
    }
}

/** Samples are taken once the least norm that makes up for their row errors is added. */
void improvePrimal (const PeakRows& rows, const Eigen::VectorXd& s, MinimumPeak& best)
{
    const auto met = rows.corrected (s);
    const auto residual = rows.residual (met);
    const auto peak = met.cwiseAbs().maxCoeff();

    if (residual <= metResidual && peak < best.upper)
    {
        best.upper = peak;
        best.samples = met;
        best.rowResidual = residual;
    }
}
} // namespace

double MinimumPeak::gap() const
{
    return upper > 0 ? (std::isfinite (upper) ? std::max (0.0, (upper - lower) / upper) : 1) : 0;
}

MinimumPeak minimumPeak (const MinimumPeakProblem& problem, double tolerance, const MinimumPeak* start)
{
    constexpr auto roomAtStart = 1.0;
    const PeakRows rows (problem);
    MinimumPeak best;
    best.upper = std::numeric_limits<double>::infinity();

    if (problem.wanted.isZero (0))
        return { 0, 0, Eigen::VectorXd::Zero (problem.wanted.size()), Eigen::VectorXd::Zero (rows.columns()), 0, 0 };

    const auto isWarm = start != nullptr && std::isfinite (start->upper) && start->upper > 0;
    const Eigen::VectorXd none = Eigen::VectorXd::Zero (problem.wanted.size());
    const Eigen::VectorXd s = isWarm ? start->samples : rows.corrected (Eigen::VectorXd::Zero (rows.columns()));
    improvePrimal (rows, s, best);

    if (! std::isfinite (best.upper))
    {
        improveDual (rows, rows.unreachable(), best);
        best.multipliers = rows.unscaled (best.multipliers);
        return best;
    }

    auto point = isWarm ? innerPoint (rows, rows.scaled (start->multipliers), s, std::max (start->gap(), tolerance))
                        : innerPoint (rows, none, s, roomAtStart);
    improveDual (rows, isWarm ? point.y : rows.leastNormMultipliers(), best);

    while (best.gap() > tolerance && best.iterations < maximumPeakSteps && advance (rows, point))
    {
        ++best.iterations;
        improveDual (rows, point.y, best);

        if (point.peak * (1 - tolerance) < best.lower || best.iterations % 8 == 0)
            improvePrimal (rows, point.s.matrix(), best);
    }

    improvePrimal (rows, point.s.matrix(), best);
    best.multipliers = rows.unscaled (best.multipliers);
    return best;
}
} // namespace antinode
