#include "Comparison.h"

#include "Assignment.h"
#include "FrequencyDrift.h"

#include <antinode_model/ShapesAtPlaces.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double minimumComparedAssurance = 0.5;
/** What a relative difference of frequencies costs, in units of MAC: one of 10 % costs 0.2. */
constexpr double differencePenalty = 2;
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

    return ascending (updated (computed, update));
}
} // namespace antinode
