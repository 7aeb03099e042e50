#include "MinimumPeak.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <array>
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

namespace
{
/** Between two looks at the watch: multiples of what a product takes at once, so that it is the same in pieces. */
constexpr Eigen::Index columnsAtOnce = 2048;

/** A positive semidefinite matrix's directions and how long each is, those of rounding left out: T with T' G T = 1. */
Eigen::MatrixXd whitenedBasis (const Eigen::MatrixXd& gram)
{
    constexpr auto smallest = 4 * std::numeric_limits<double>::epsilon();
    auto [values, vectors] = symmetricEigen (gram);
    const auto minimum = smallest * values.sum();
    Eigen::Index first = 0;

    while (first < values.size() && values[first] <= minimum)
        ++first;

    const auto rank = values.size() - first;
    return vectors.rightCols (rank) * values.tail (rank).cwiseSqrt().cwiseInverse().asDiagonal();
}
} // namespace

PeakRows::PeakRows (const MinimumPeakProblem& problem) : ceramics (problem.ceramics)
{
    const auto rows = problem.wanted.size();
    Eigen::VectorXd squares = Eigen::VectorXd::Zero (rows);
    absoluteValues = Eigen::VectorXd::Zero (rows);
    offsets.push_back (0);

    for (const auto& [gains, weights] : ceramics)
    {
        checkWatch();
        offsets.push_back (offsets.back() + weights->cols());
        squares += gains.cwiseAbs2().cwiseProduct (weights->rowwise().squaredNorm());
        absoluteValues += gains.cwiseAbs().cwiseProduct (weights->rowwise().lpNorm<1>());
    }

    scale = (squares.array() > 0).select (squares.cwiseSqrt().cwiseInverse(), 0);

    for (auto& ceramic : ceramics)
        ceramic.gains = ceramic.gains.cwiseProduct (scale);

    wantedValues = scale.cwiseProduct (problem.wanted);
    absoluteValues = absoluteValues.cwiseProduct (scale);
    basis = whitenedBasis (gram (nullptr));
}

Eigen::VectorXd PeakRows::pulls (const Eigen::VectorXd& y) const
{
    Eigen::VectorXd result = Eigen::VectorXd::Zero (columns());

    for (std::size_t i = 0; i < ceramics.size(); ++i)
    {
        const auto& [gains, weights] = ceramics[i];
        addTransposedLeft (result.segment (offsets[i], weights->cols()), 1, *weights, gains.cwiseProduct (y));
    }

    return result;
}

Eigen::VectorXd PeakRows::values (const Eigen::VectorXd& s) const
{
    Eigen::VectorXd result = Eigen::VectorXd::Zero (wantedValues.size());

    for (std::size_t i = 0; i < ceramics.size(); ++i)
    {
        const auto& [gains, weights] = ceramics[i];
        Eigen::VectorXd sums = Eigen::VectorXd::Zero (result.size());

        for (Eigen::Index first = 0; first < weights->cols(); first += columnsAtOnce)
        {
            checkWatch();
            const auto count = std::min (columnsAtOnce, weights->cols() - first);
            sums += weights->middleCols (first, count) * s.segment (offsets[i] + first, count);
        }

        result += gains.cwiseProduct (sums);
    }

    return result;
}

/** A diag (weights) A', its lower triangle; without weights those of 1. */
Eigen::MatrixXd PeakRows::gram (const Eigen::ArrayXd* columnWeights) const
{
    const auto rows = wantedValues.size();
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero (rows, rows), part;

    for (std::size_t i = 0; i < ceramics.size(); ++i)
    {
        const auto& [gains, weights] = ceramics[i];

        if (columnWeights != nullptr || i == 0 || weights != ceramics[i - 1].weights)
        {
            part = Eigen::MatrixXd::Zero (rows, rows);

            for (Eigen::Index first = 0; first < weights->cols(); first += columnsAtOnce)
            {
                const auto count = std::min (columnsAtOnce, weights->cols() - first);
                const auto some = weights->middleCols (first, count);

                if (columnWeights != nullptr)
                    addGram (part, 1,
                             some * columnWeights->segment (offsets[i] + first, count).sqrt().matrix().asDiagonal());
                else
                    addGram (part, 1, some);
            }
        }

        for (Eigen::Index k = 0; k < rows; ++k)
            sum.col (k).tail (rows - k) += gains[k] * gains.tail (rows - k).cwiseProduct (part.col (k).tail (rows - k));
    }

    return sum;
}

Eigen::MatrixXd PeakRows::factored (const Eigen::ArrayXd& weights) const
{
    constexpr std::array lifts { 1e-15, 1e-13, 1e-11, 1e-9, 1e-7 };
    const Eigen::MatrixXd whole = gram (&weights).selfadjointView<Eigen::Lower>();
    Eigen::MatrixXd half = Eigen::MatrixXd::Zero (whole.rows(), basis.cols());
    Eigen::MatrixXd whitened = Eigen::MatrixXd::Zero (basis.cols(), basis.cols());
    addProduct (half, 1, whole, basis);
    addTransposedLeft (whitened, 1, basis, half);

    for (const auto lift : lifts)
    {
        Eigen::MatrixXd factor = whitened;
        factor.diagonal() *= 1 + lift;

        if (factorLower (factor) && factor.allFinite())
            return factor;
    }

    return {};
}

Eigen::VectorXd PeakRows::solved (const Eigen::MatrixXd& factor, const Eigen::VectorXd& values) const
{
    if (factor.size() == 0)
        return Eigen::VectorXd::Zero (values.size());

    Eigen::MatrixXd x = basis.transpose() * values;
    solveLower (factor, x);
    solveLowerTransposed (factor, x);
    return basis * x;
}

Eigen::VectorXd PeakRows::corrected (Eigen::VectorXd s) const
{
    constexpr auto maximumRefinements = 12;
    constexpr auto rounding = 1e-3; // of the residual that is accepted

    for (int i = 0; i < maximumRefinements && (i < 2 || residual (s) > rounding * metResidual); ++i)
    {
        const Eigen::VectorXd missing = wantedValues - values (s);
        s += pulls (basis * (basis.transpose() * missing));
    }

    return s;
}

double PeakRows::residual (const Eigen::VectorXd& s) const
{
    constexpr auto rounding = 1e-4; // times the accepted 1e-9: 1e-13 of what is summed
    const Eigen::ArrayXd error = (wantedValues - values (s)).array().abs();
    const Eigen::ArrayXd beside =
        wantedValues.array().abs() + rounding * s.cwiseAbs().maxCoeff() * absoluteValues.array();
    return (beside > 0).select (error / beside, error).maxCoeff();
}

Eigen::VectorXd PeakRows::unreachable() const
{
    return wantedValues - values (pulls (leastNormMultipliers()));
}
} // namespace antinode
