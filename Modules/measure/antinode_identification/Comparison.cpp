#include "Comparison.h"

#include "Assignment.h"
#include "FrequencyDrift.h"

#include <antinode_model/ShapesAtPlaces.h>
#include <antinode_numerics/Median.h>

#include <algorithm>
#include <cmath>

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
} // namespace antinode
