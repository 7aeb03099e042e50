#include "GaussNewton.h"

#include "DenseKernels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace antinode
{
namespace
{
using Places = Eigen::VectorX<Eigen::Index>;

Places placesWhere (const Eigen::Array<bool, Eigen::Dynamic, 1>& wanted)
{
    Places places (wanted.count());
    Eigen::Index next = 0;

    for (Eigen::Index p = 0; p < wanted.size(); ++p)
        if (wanted[p])
            places[next++] = p;

    return places;
}

/** Unknowns that are held in a step. */
struct Held
{
    Places places;
    Eigen::VectorXd changes; ///< Theirs.
};

Held heldAt (const Eigen::VectorXi& atBound, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper)
{
    auto places = placesWhere (atBound.array() != 0);
    Eigen::VectorXd changes = (atBound.array() > 0).select (upper, lower) (places);
    return { std::move (places), std::move (changes) };
}

/** A step of all unknowns, and the slope that holding leaves, downhill: 0 of those that are free. */
struct HeldStep
{
    Eigen::VectorXd change, slope;
};

/** Columns of the inverse of a factor, places ascending: each begins at its own row. */
Eigen::MatrixXd columnsOfInverse (const Eigen::MatrixXd& factored, const Places& places)
{
    constexpr Eigen::Index width = 64; // columns at a time
    const auto count = places.size();
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero (factored.rows(), count);

    for (Eigen::Index i = 0; i < count; ++i)
        columns (places[i], i) = 1;

    for (Eigen::Index first = 0; first < count; first += width)
    {
        const auto rows = factored.rows() - places[first];
        solveLower (factored.bottomRightCorner (rows, rows),
                    columns.block (factored.rows() - rows, first, rows, std::min (width, count - first)));
    }

    return columns;
}

/** Where few are held: by the forces f that hold them, M x = r + E f with E' x = changes, from the factor of the whole
    matrix.
    @param half  L^-1 r */
HeldStep heldByForces (const Eigen::MatrixXd& factored, const Eigen::VectorXd& half, const Held& held)
{
    const auto columns = columnsOfInverse (factored, held.places);
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero (columns.cols(), columns.cols()); // E' M^-1 E
    addGram (gram, 1, columns.transpose());
    factorLower (gram);
    const Eigen::VectorXd forces = solveFactored (gram, held.changes - columns.transpose() * half);
    HeldStep step { half + columns * forces, Eigen::VectorXd::Zero (half.size()) };
    solveLowerTransposed (factored, step.change);
    step.slope (held.places) = -forces;
    return step;
}

/** Where most are held: from the equations of the others. */
HeldStep mostlyHeld (const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right, const Places& free, const Held& held)
{
    const auto whole = matrix.selfadjointView<Eigen::Lower>();
    HeldStep step { Eigen::VectorXd::Zero (right.size()), {} };
    step.change (held.places) = held.changes;
    const Eigen::VectorXd rest = right - whole * step.change;
    Eigen::MatrixXd some = matrix (free, free);
    factorLower (some);
    step.change (free) = solveFactored (some, rest (free));
    step.slope = right - whole * step.change;
    step.slope (free).setZero();
    return step;
}

/** Which unknowns are at their bounds after a step: 1 at the upper, -1 at the lower one, 0 at neither.
    @param before  those that were held there in this step
    @param slope   downhill, after the step */
Eigen::VectorXi boundsReached (const Eigen::VectorXi& before, const Eigen::VectorXd& slope,
                               const Eigen::VectorXd& change, const Eigen::VectorXd& lower,
                               const Eigen::VectorXd& upper)
{
    constexpr double rounding = 1e-9;
    Eigen::VectorXi reached (before.size());

    for (Eigen::Index p = 0; p < reached.size(); ++p)
    {
        const auto isPushedOn = before[p] != 0 && before[p] * slope[p] > 0;
        const auto isAbove = before[p] == 0 && change[p] > upper[p] + rounding;
        const auto isBelow = before[p] == 0 && change[p] < lower[p] - rounding;
        reached[p] = isPushedOn ? before[p] : isAbove ? 1 : isBelow ? -1 : 0;
    }

    return reached;
}
} // namespace

BoundedStep boundedStep (const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right, const Eigen::VectorXd& lower,
                         const Eigen::VectorXd& upper)
{
    constexpr int mostRounds = 8; // Seldom more than three; what is left is cut off.
    BoundedStep result { {}, matrix, Eigen::VectorXi::Zero (right.size()) };
    factorLower (result.factored);
    Eigen::VectorXd half = right;
    solveLower (result.factored, half);

    for (int round = 1;; ++round)
    {
        const auto held = heldAt (result.held, lower, upper);
        const auto free = placesWhere (result.held.array() == 0);
        const auto [change, slope] = held.places.size() < free.size() ? heldByForces (result.factored, half, held)
                                                                      : mostlyHeld (matrix, right, free, held);
        auto reached = boundsReached (result.held, slope, change, lower, upper);

        if (reached == result.held || round == mostRounds)
        {
            result.change = change.cwiseMax (lower).cwiseMin (upper);
            return result;
        }

        result.held = std::move (reached);
    }
}

Eigen::MatrixXd factorOfFree (BoundedStep step, Eigen::MatrixXd matrix)
{
    const auto held = placesWhere (step.held.array() != 0);

    if (held.size() == 0)
        return std::move (step.factored);

    step.factored.resize (0, 0); // before the other one is factored

    for (const auto p : held)
    {
        matrix.row (p).setZero();
        matrix.col (p).setZero();
        matrix (p, p) = 1;
    }

    factorLower (matrix);
    return matrix;
}

SmallestSum smallestSum (const SumOfSquares& squares, Eigen::VectorXd start, const GaussNewtonSettings& settings)
{
    constexpr double smallestShare = 0.125; // of a step
    constexpr double farthestReach = 8;
    const auto& bounds = settings.bounds;
    SmallestSum result { std::move (start), {}, 0 };
    BoundedStep step;
    Eigen::MatrixXd matrix; // the step's
    auto gain = std::numeric_limits<double>::infinity(), reach = 1.0;

    for (int i = 0; i < settings.mostSteps && gain >= settings.leastGain + settings.leastShare * result.sum; ++i)
    {
        step.factored.resize (0, 0); // before others of its size are made
        matrix.resize (0, 0);
        auto linear = squares.equations (result.values);
        const Eigen::VectorXd from = result.values;
        result.sum = linear.sum;
        step = boundedStep (linear.matrix, linear.right, (-bounds - from).cwiseMax (-reach * settings.stepLimits),
                            (bounds - from).cwiseMin (reach * settings.stepLimits));
        matrix = std::move (linear.matrix);

        for (auto share = 1.0; share >= smallestShare && ! (result.sum < linear.sum); share /= 2)
        {
            const Eigen::VectorXd next = (from + share * step.change).cwiseMax (-bounds).cwiseMin (bounds);

            if (const auto reached = squares.sum (next); reached < linear.sum)
            {
                result.sum = reached;
                result.values = next;
                reach = share < 1 ? share * reach : std::min (2 * reach, farthestReach);
            }
        }

        gain = linear.sum - result.sum;

        if (settings.isHopeless && settings.isHopeless (i + 1, result.sum))
            break;
    }

    result.factored = factorOfFree (std::move (step), std::move (matrix));
    return result;
}
} // namespace antinode
