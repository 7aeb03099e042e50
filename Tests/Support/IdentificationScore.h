#pragma once

#include "MeasuredStructure.h"

namespace antinode::test
{
/** How identified modes compare with the true ones. Errors of the found modes, ascending. */
struct IdentificationScore
{
    int found = 0, falseOnes = 0;
    std::vector<double> frequency; ///< Relative.
    std::vector<double> damping;   ///< Relative.
    std::vector<double> assurance; ///< 1 - MAC.
    std::vector<double>
        participation; ///< Length of the error over the length of the row, at equal length of the shapes.
    double zFrequency = 0, zDamping = 0, zShape = 0, zParticipation = 0; ///< RMS of error over stated deviation.
};

inline double quantile (const std::vector<double>& ascending, double share)
{
    return ascending.empty()
               ? 1e9
               : ascending[static_cast<std::size_t> (std::ceil (share * static_cast<double> (ascending.size() - 1)))];
}

/** Each identified mode belongs to the true one that is nearest in frequency, within its half width; each true one
    counts once. */
inline IdentificationScore score (const IdentifiedModes& modes, const KnownStructure& truth)
{
    IdentificationScore result;
    std::vector<bool> taken (static_cast<std::size_t> (truth.frequencies.size()));
    double shapes = 0, participations = 0;

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
    {
        const auto frequency = modes.angularFrequencies[k] / (2 * std::numbers::pi);
        Eigen::Index j = 0;
        (truth.frequencies.array() - frequency).abs().minCoeff (&j);

        if (taken[static_cast<std::size_t> (j)]
            || std::abs (frequency / truth.frequencies[j] - 1) > truth.dampingRatios[j])
        {
            ++result.falseOnes;
            continue;
        }

        taken[static_cast<std::size_t> (j)] = true;
        ++result.found;
        const Eigen::VectorXd shape = modes.shapes.col (k), trueShape = truth.shapes.col (j);
        const auto size = trueShape.norm() / shape.norm() * (shape.dot (trueShape) < 0 ? -1 : 1);
        const auto cosine = shape.dot (trueShape) / (shape.norm() * trueShape.norm());
        const Eigen::RowVectorXd error = modes.participation.row (k) / size - truth.participation.row (j);
        result.frequency.push_back (std::abs (frequency / truth.frequencies[j] - 1));
        result.damping.push_back (std::abs (modes.dampingRatios[k] / truth.dampingRatios[j] - 1));
        result.assurance.push_back (1 - cosine * cosine);
        result.participation.push_back (error.norm() / truth.participation.row (j).norm());
        const auto& deviations = modes.deviations;
        result.zFrequency +=
            std::pow ((frequency - truth.frequencies[j]) * 2 * std::numbers::pi / deviations.angularFrequencies[k], 2);
        result.zDamping +=
            std::pow ((modes.dampingRatios[k] - truth.dampingRatios[j]) / deviations.dampingRatios[k], 2);
        shapes += ((shape * size - trueShape).array() / (deviations.shapes.col (k).array() * size)).square().mean();
        participations += (error.array() / (deviations.participation.row (k).array() / size)).square().mean();
    }

    const auto count = std::max (result.found, 1);
    result.zFrequency = std::sqrt (result.zFrequency / count);
    result.zDamping = std::sqrt (result.zDamping / count);
    result.zShape = std::sqrt (shapes / count);
    result.zParticipation = std::sqrt (participations / count);

    for (auto* const errors : { &result.frequency, &result.damping, &result.assurance, &result.participation })
        std::sort (errors->begin(), errors->end());

    return result;
}
} // namespace antinode::test
