#include "FrequencyCorrection.h"

#include "PlateSection.h"
#include "SoftLayers.h"
#include "ThickPlates.h"

#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
LossyFrequency waveAt (const StructureCommon& common, double waveNumber)
{
    if (hasSoftLayers (common))
        return lossyFrequencyAt (common, waveNumber);

    return { mindlinFrequencyAt (common, waveNumber), 0 };
}

/** The wave number of a frequency, by bisection between octaves: frequencies ascend with it. */
double waveNumberOf (const StructureCommon& common, double angularFrequency)
{
    double low = std::sqrt (angularFrequency / thinWaveFactor (common)), high = low;

    while (waveAt (common, low).angularFrequency > angularFrequency)
        low /= 2;

    while (waveAt (common, high).angularFrequency < angularFrequency)
        high *= 2;

    constexpr double exact = 1e-9;

    while (high / low > 1 + exact)
    {
        const auto middle = std::sqrt (low * high);
        (waveAt (common, middle).angularFrequency > angularFrequency ? high : low) = middle;
    }

    return high;
}

/** The moment per volt of each ceramic, the sum of both directions, with soft layers taken at a reference; 1 N/V where
   it has none. */
Eigen::ArrayXXd momentsAt (StructureCommon common, const SectionReference& reference)
{
    common.reference = reference;
    Eigen::ArrayXXd moments (1, static_cast<Eigen::Index> (common.ceramics.size()));

    for (std::size_t i = 0; i < common.ceramics.size(); ++i)
    {
        const auto moment = ceramicSection (common, common.ceramics[i]);
        const auto sum = moment.momentX + moment.momentY;
        moments (0, static_cast<Eigen::Index> (i)) = sum == 0 ? 1 : sum;
    }

    return moments;
}
} // namespace

bool needsCorrection (const StructureCommon& common)
{
    return hasSoftLayers (common) || common.theory == BendingTheory::thick;
}

StructureCommon asSolved (StructureCommon common, double waveNumber)
{
    if (! needsCorrection (common))
        return common;

    std::optional<double> highest;

    if (common.maximumFrequency)
        highest = waveNumberOf (common, 2 * std::numbers::pi * *common.maximumFrequency);

    if (hasSoftLayers (common))
    {
        const auto middle = highest ? *highest / 2 : waveNumber;
        common.reference = { middle, lossyFrequencyAt (common, middle).angularFrequency };
    }

    if (highest)
        common.maximumFrequency = *highest * *highest * thinWaveFactor (common) / (2 * std::numbers::pi);

    return common;
}

void correctFrequencies (ModalModel& model, const StructureCommon& common)
{
    if (! needsCorrection (common))
        return;

    const auto factor = thinWaveFactor (common);
    const auto solvedMoments = momentsAt (common, common.reference);

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        const auto waveNumber = std::sqrt (model.angularFrequencies[k] / factor);
        const auto corrected = waveAt (common, waveNumber);
        model.angularFrequencies[k] = corrected.angularFrequency;
        model.dampingRatios[k] += corrected.lossFactor / 2;

        if (hasSoftLayers (common))
            model.participation.row (k).array() *=
                momentsAt (common, { waveNumber, corrected.angularFrequency }) / solvedMoments;
    }
}
} // namespace antinode
