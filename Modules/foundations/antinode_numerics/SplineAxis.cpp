#include "SplineAxis.h"

#include <algorithm>

namespace antinode
{
namespace
{
/** The knots: the ends as often as the order, the others as often as their multiplicity. */
Eigen::VectorXd makeKnots (const SplineBreaks& breaks, int order)
{
    const auto last = breaks.places.size() - 1;
    auto repeated = breaks.multiplicity;
    repeated[0] = repeated[last] = order;
    Eigen::VectorXd knots (repeated.sum());
    Eigen::Index next = 0;

    for (Eigen::Index i = 0; i <= last; ++i)
        for (int j = 0; j < repeated[i]; ++j)
            knots[next++] = breaks.places[i];

    return knots;
}

/** The values at one place of the splines of all orders up to the given one, by Cox's and de Boor's recurrence:
   `values` holds the last `order` of them. */
Eigen::VectorXd splineValues (const Eigen::VectorXd& knots, Eigen::Index left, int order, double place)
{
    Eigen::VectorXd values = Eigen::VectorXd::Zero (order);
    values[0] = 1;

    for (int k = 1; k < order; ++k)
    {
        double carried = 0;

        for (int r = 0; r < k; ++r)
        {
            const auto right = knots[left + r + 1], begin = knots[left + r + 1 - k];
            const auto share = values[r] / (right - begin);
            values[r] = carried + (right - place) * share;
            carried = (place - begin) * share;
        }

        values[k] = carried;
    }

    return values;
}

/** A derivative of the splines at one place: those of a lower order, differenced as often as it takes. */
Eigen::VectorXd splineDerivatives (const Eigen::VectorXd& knots, Eigen::Index left, int order, double place,
                                   int derivative)
{
    Eigen::VectorXd values = Eigen::VectorXd::Zero (order);
    values.head (order - derivative) = splineValues (knots, left, order - derivative, place);

    for (int k = order - derivative; k < order; ++k)
    {
        double carried = 0;

        for (int r = 0; r < k; ++r)
        {
            const auto slope = k * values[r] / (knots[left + r + 1] - knots[left + r + 1 - k]);
            values[r] = carried - slope;
            carried = slope;
        }

        values[k] = carried;
    }

    return values;
}
} // namespace

SplineAxis::SplineAxis (const SplineBreaks& breaksToUse, int degree)
    : breaks (breaksToUse), order (degree + 1), knots (makeKnots (breaks, order)), lastKnot (breaks.places.size() - 1),
      count (knots.size() - order - breaks.heldAtStart - breaks.heldAtEnd)
{
    lastKnot[0] = degree;

    for (Eigen::Index cell = 1; cell < cells(); ++cell)
        lastKnot[cell] = lastKnot[cell - 1] + breaks.multiplicity[cell];
}

SplineAxis SplineAxis::withDegree (int degree) const
{
    auto changed = breaks;
    changed.multiplicity.array() += degree - this->degree();
    changed.multiplicity = (breaks.multiplicity.array() > 1).select (changed.multiplicity.cwiseMax (1), 1);
    return { changed, degree };
}

double SplineAxis::centre (Eigen::Index spline) const
{
    return knots.segment (spline + breaks.heldAtStart + 1, degree()).mean();
}

Eigen::Index SplineAxis::cellAt (double place) const
{
    const auto* const begin = breaks.places.data();
    const auto after = std::upper_bound (begin, begin + breaks.places.size(), place) - begin;
    return std::clamp<Eigen::Index> (after - 1, 0, cells() - 1);
}

Eigen::Index SplineAxis::lastNeighbour (Eigen::Index spline) const
{
    // The support ends where the cell of its last knot begins; on the cell before that the last spline is the one of
    // this cell's knot.
    const auto* const begin = lastKnot.data();
    const auto cell =
        std::lower_bound (begin, begin + lastKnot.size(), spline + breaks.heldAtStart + order) - begin - 1;
    return std::min<Eigen::Index> (lastKnot[cell] - breaks.heldAtStart, count - 1);
}

SplineValues SplineAxis::onCell (Eigen::Index cell, const Eigen::VectorXd& at, int derivative) const
{
    const auto left = lastKnot[cell];
    const auto first = left - order + 1 - breaks.heldAtStart;
    const auto begin = std::max<Eigen::Index> (first, 0);
    const auto end = std::min<Eigen::Index> (first + order, count);
    SplineValues result { begin, Eigen::MatrixXd (at.size(), end - begin) };

    for (Eigen::Index i = 0; i < at.size(); ++i)
        if (i > 0 && at[i] == at[i - 1]) // as along the rows of a cell
            result.values.row (i) = result.values.row (i - 1);
        else
            result.values.row (i) = splineDerivatives (knots, left, order, at[i], derivative)
                                        .segment (begin - first, end - begin)
                                        .transpose();

    return result;
}

Eigen::MatrixXd SplineAxis::at (const Eigen::VectorXd& where, int derivative) const
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (where.size(), count);

    for (Eigen::Index i = 0; i < where.size(); ++i)
    {
        const auto some = onCell (cellAt (where[i]), where.segment<1> (i), derivative);
        result.row (i).segment (some.first, some.values.cols()) = some.values;
    }

    return result;
}
} // namespace antinode
