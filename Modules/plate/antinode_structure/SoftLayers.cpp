#include "SoftLayers.h"

#include "PlateSection.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
StructureCommon referredTo (StructureCommon common, double waveNumber, double angularFrequency)
{
    common.ceramics.clear();
    common.reference = { waveNumber, angularFrequency };
    return common;
}
} // namespace

bool hasSoftLayers (const StructureCommon& common)
{
    return std::any_of (common.layers.begin(), common.layers.end(),
                        [] (const LayerDescription& layer)
                        { return std::holds_alternative<ViscoelasticMaterial> (layer.material); });
}

std::complex<double> stiffnessAt (const StructureCommon& common, double waveNumber, double angularFrequency)
{
    const auto stiffness = bareStack (referredTo (common, waveNumber, angularFrequency)).stiffness;
    return std::sqrt (stiffness (0, 0)) * std::sqrt (stiffness (1, 1));
}

LossyFrequency lossyFrequencyAt (const StructureCommon& common, double waveNumber)
{
    constexpr double converged = 1e-13;
    constexpr int steps = 200;
    const auto factor = std::pow (waveNumber, 4) / bareStack (common).massPerArea;
    double angularFrequency = std::sqrt (factor * stiffnessAt (common, waveNumber, 1).real());

    // A modulus grows at most as the frequency, stiffness and square of the frequency less: each step is nearer.
    for (int i = 0; i < steps; ++i)
    {
        const auto next = std::sqrt (factor * stiffnessAt (common, waveNumber, angularFrequency).real());
        const auto change = std::abs (next / angularFrequency - 1);
        angularFrequency = next;

        if (change < converged)
            break;
    }

    const auto stiffness = stiffnessAt (common, waveNumber, angularFrequency);
    return { angularFrequency, stiffness.imag() / stiffness.real() };
}
} // namespace antinode
