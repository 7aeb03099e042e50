#include "Comparison.h"

#include "KnownModes.h"

#include <antinode_model/ModalModel.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace antinode
{
namespace
{
constexpr double minimumComparedAssurance = 0.5;
/** What a relative difference of frequencies costs, in units of MAC: one of 10 % costs 0.2. */
constexpr double differencePenalty = 2;

/** The computed participations with the measured ones in their place: shape times participation is what was measured.
 */
Eigen::MatrixXd measuredParticipation (const ModalModel& computed, const IdentifiedModes& identified,
                                       const ModeComparison& comparison)
{
    const auto shapes = shapesAtPlaces (computed, identified.points);
    Eigen::MatrixXd result = computed.participation;
    Eigen::RowVectorXd products = Eigen::RowVectorXd::Zero (result.cols()), energies = products;
    std::vector<bool> isMeasured (static_cast<std::size_t> (computed.modes()));

    for (const auto& pair : comparison.pairs)
    {
        const auto drawn = computed.participation.row (pair.computed);
        const auto shape = shapes.col (pair.computed), found = identified.shapes.col (pair.identified);
        double common = 0, whole = 0;

        for (Eigen::Index p = 0; p < shape.size(); ++p)
            if (std::isfinite (found[p]))
            {
                common += shape[p] * found[p];
                whole += shape[p] * shape[p];
            }

        const Eigen::RowVectorXd measured = common / whole * identified.participation.row (pair.identified);
        result.row (pair.computed) = measured;
        isMeasured[static_cast<std::size_t> (pair.computed)] = true;
        products += measured.cwiseProduct (drawn);
        energies += drawn.cwiseAbs2();
    }

    for (Eigen::Index k = 0; k < result.rows(); ++k)
        if (! isMeasured[static_cast<std::size_t> (k)])
            result.row (k).array() *= (energies.array() > 0).select (products.array() / energies.array(), 1.0);

    return result;
}
} // namespace

Eigen::MatrixXd modalAssurance (const Eigen::MatrixXd& one, const Eigen::MatrixXd& other,
                                const Eigen::VectorXd& weights)
{
    std::vector<Eigen::Index> rows;

    for (Eigen::Index p = 0; p < one.rows(); ++p)
        if (one.row (p).allFinite() && other.row (p).allFinite())
            rows.push_back (p);

    const Eigen::VectorXd used = weights.size() > 0 ? Eigen::VectorXd (weights (rows))
                                                    : Eigen::VectorXd::Ones (static_cast<Eigen::Index> (rows.size()));
    const Eigen::MatrixXd a = used.cwiseSqrt().asDiagonal() * one (rows, Eigen::all);
    const Eigen::MatrixXd b = used.cwiseSqrt().asDiagonal() * other (rows, Eigen::all);
    const Eigen::VectorXd lengthsOfOne = a.colwise().squaredNorm(), lengthsOfOther = b.colwise().squaredNorm();
    return (a.transpose() * b)
        .cwiseAbs2()
        .cwiseQuotient ((lengthsOfOne * lengthsOfOther.transpose()).cwiseMax (1e-300));
}

ModeComparison compareModes (const IdentifiedModes& identified, const ModalModel& computed)
{
    requireRealModes (computed, "comparisons with other modes");
    ModeComparison result;
    result.assurance = modalAssurance (identified.shapes, shapesAtPlaces (computed, identified.points), {});
    Eigen::MatrixXd scores = result.assurance;

    for (Eigen::Index k = 0; k < scores.rows(); ++k)
        for (Eigen::Index l = 0; l < scores.cols(); ++l)
            scores (k, l) -= differencePenalty
                             * std::abs (std::log (identified.angularFrequencies[k] / computed.angularFrequencies[l]));

    const auto partners = assign (scores);

    for (Eigen::Index k = 0; k < scores.rows(); ++k)
        if (const auto l = partners[static_cast<std::size_t> (k)];
            l >= 0 && result.assurance (k, l) >= minimumComparedAssurance)
            result.pairs.push_back ({ k, l, result.assurance (k, l),
                                      identified.angularFrequencies[k] / computed.angularFrequencies[l] - 1 });

    return result;
}

ModalModel transferred (const ModalModel& computed, const IdentifiedModes& identified, const ModeComparison& comparison)
{
    ModeUpdate update { Eigen::VectorXd::Zero (computed.modes()), Eigen::VectorXd::Zero (computed.modes()),
                        std::vector<bool> (static_cast<std::size_t> (computed.modes())) };

    for (const auto& pair : comparison.pairs)
    {
        update.isKnown[static_cast<std::size_t> (pair.computed)] = true;
        update.angularFrequencies[pair.computed] = identified.angularFrequencies[pair.identified];
        update.dampingRatios[pair.computed] = identified.dampingRatios[pair.identified];
    }

    auto changed = updated (computed, update);

    if (identified.drive == DriveQuantity::voltage && identified.complexShapes.size() == 0
        && identified.participation.cols() == computed.actuators() && ! comparison.pairs.empty())
    {
        std::vector<double> apart; // Sines of the angles between drawn and measured shapes.

        for (const auto& pair : comparison.pairs)
            apart.push_back (std::sqrt (std::max (0.0, 1 - pair.assurance)));

        changed.participation = measuredParticipation (computed, identified, comparison);
        changed.origin = { ModeSource::retuned, static_cast<int> (identified.points.rows()), median (std::move (apart)),
                           computed.origin.scaleIsKnown };
    }

    return ascending (std::move (changed));
}

namespace
{
/** Rows assigned one after the other, each by a shortest augmenting path; columns count from 1, 0 stands for none. */
class ShortestPaths
{
public:
    explicit ShortestPaths (const Eigen::MatrixXd& costsToUse)
        : costs (costsToUse), rowPrice (Eigen::VectorXd::Zero (costs.rows() + 1)),
          columnPrice (Eigen::VectorXd::Zero (costs.cols() + 1)), assignedRows (columnCount(), 0)
    {
    }

    void add (Eigen::Index row)
    {
        std::vector<Eigen::Index> before (columnCount(), 0);
        std::vector<bool> seen (columnCount(), false);
        std::vector<double> minimumCost (columnCount(), std::numeric_limits<double>::infinity());
        assignedRows[0] = row + 1;
        std::size_t column = 0;

        do
        {
            seen[column] = true;
            column = advance (column, before, seen, minimumCost);
        } while (assignedRows[column] != 0);

        for (; column != 0; column = static_cast<std::size_t> (before[column]))
            assignedRows[column] = assignedRows[static_cast<std::size_t> (before[column])];
    }

    Eigen::Index assignedRow (Eigen::Index column) const
    {
        return assignedRows[static_cast<std::size_t> (column + 1)] - 1;
    }

private:
    std::size_t columnCount() const { return static_cast<std::size_t> (costs.cols() + 1); }

    /** One step of Dijkstra's method over reduced costs. @return the next column */
    std::size_t advance (std::size_t column, std::vector<Eigen::Index>& before, const std::vector<bool>& seen,
                         std::vector<double>& minimumCost)
    {
        const auto row = assignedRows[column];
        auto delta = std::numeric_limits<double>::infinity();
        std::size_t next = 0;

        for (std::size_t j = 1; j < columnCount(); ++j)
        {
            if (seen[j])
                continue;

            const auto index = static_cast<Eigen::Index> (j);

            if (const auto cost = costs (row - 1, index - 1) - rowPrice[row] - columnPrice[index];
                cost < minimumCost[j])
            {
                minimumCost[j] = cost;
                before[j] = static_cast<Eigen::Index> (column);
            }

            if (minimumCost[j] < delta)
            {
                delta = minimumCost[j];
                next = j;
            }
        }

        for (std::size_t j = 0; j < columnCount(); ++j)
        {
            if (seen[j])
            {
                rowPrice[assignedRows[j]] += delta;
                columnPrice[static_cast<Eigen::Index> (j)] -= delta;
            }
            else
            {
                minimumCost[j] -= delta;
            }
        }

        return next;
    }

    const Eigen::MatrixXd& costs;
    Eigen::VectorXd rowPrice, columnPrice;
    std::vector<Eigen::Index> assignedRows;
};
} // namespace

std::vector<Eigen::Index> assign (const Eigen::MatrixXd& scores)
{
    const auto isWide = scores.rows() <= scores.cols();
    const Eigen::MatrixXd costs = isWide ? Eigen::MatrixXd (-scores) : Eigen::MatrixXd (-scores.transpose());
    ShortestPaths paths (costs);
    std::vector<Eigen::Index> result (static_cast<std::size_t> (scores.rows()), -1);

    for (Eigen::Index row = 0; row < costs.rows(); ++row)
        paths.add (row);

    for (Eigen::Index column = 0; column < costs.cols(); ++column)
        if (const auto row = paths.assignedRow (column); row >= 0)
            result[static_cast<std::size_t> (isWide ? row : column)] = isWide ? column : row;

    return result;
}

namespace
{
constexpr int neighbours = 5; // on either side: one alone may differ from the others as much as the mode itself

/** What known modes on one side say, mean values. */
struct Side
{
    double change = 0, angularFrequency = 0; ///< Relative, rad/s.
    int count = 0;
};

/** Of the known modes nearest to a mode. @param step  1: above it, -1: below it */
Side sideOf (const ModalModel& model, const ModeUpdate& update, Eigen::Index mode, Eigen::Index step)
{
    Side side;

    for (auto k = mode + step; k >= 0 && k < model.modes() && side.count < neighbours; k += step)
        if (update.isKnown[static_cast<std::size_t> (k)])
        {
            side.change += update.angularFrequencies[k] / model.angularFrequencies[k];
            side.angularFrequency += model.angularFrequencies[k];
            ++side.count;
        }

    side.change /= std::max (1, side.count);
    side.angularFrequency /= std::max (1, side.count);
    return side;
}

/** The relative change at a mode: its own or, where that is not known, between those of its known neighbours. */
double changeAt (const ModalModel& model, const ModeUpdate& update, Eigen::Index mode)
{
    if (update.isKnown[static_cast<std::size_t> (mode)])
        return update.angularFrequencies[mode] / model.angularFrequencies[mode];

    const auto below = sideOf (model, update, mode, -1), above = sideOf (model, update, mode, 1);

    if (below.count == 0 || above.count == 0)
        return below.count > 0 ? below.change : above.count > 0 ? above.change : 1;

    const auto width = above.angularFrequency - below.angularFrequency;
    const auto share = width > 0 ? (model.angularFrequencies[mode] - below.angularFrequency) / width : 0.5;
    return below.change + share * (above.change - below.change);
}
} // namespace

ModalModel updated (ModalModel model, const ModeUpdate& update)
{
    Eigen::VectorXd frequencies (model.modes());

    for (Eigen::Index k = 0; k < model.modes(); ++k)
        frequencies[k] = model.angularFrequencies[k] * changeAt (model, update, k);

    for (Eigen::Index k = 0; k < model.modes(); ++k)
        if (update.isKnown[static_cast<std::size_t> (k)])
            model.dampingRatios[k] = update.dampingRatios[k];

    model.angularFrequencies = frequencies;
    return model;
}

std::optional<double> usualModelError (const ModalModel& model)
{
    const KnownSpread spread;
    return model.origin.source == ModeSource::drawn ? std::optional (std::hypot (spread.frequency, spread.drift))
                                                    : std::nullopt;
}

ModalModel withModes (ModalModel model, const std::vector<Eigen::Index>& modes)
{
    model.angularFrequencies = model.angularFrequencies (modes).eval();
    model.dampingRatios = model.dampingRatios (modes).eval();
    model.shapes = model.shapes (Eigen::all, modes).eval();
    model.participation = model.participation (modes, Eigen::all).eval();

    if (model.slopes.size() > 0)
        model.slopes = model.slopes (Eigen::all, modes).eval();

    if (model.frequencyErrors.size() > 0)
        model.frequencyErrors = model.frequencyErrors (modes).eval();

    return model;
}

ModalModel ascending (ModalModel model)
{
    std::vector<Eigen::Index> order (static_cast<std::size_t> (model.modes()));
    std::iota (order.begin(), order.end(), 0);
    std::stable_sort (order.begin(), order.end(),
                      [&model] (auto a, auto b) { return model.angularFrequencies[a] < model.angularFrequencies[b]; });
    return withModes (std::move (model), order);
}
} // namespace antinode
