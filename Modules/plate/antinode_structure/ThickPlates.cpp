#include "ThickPlates.h"

#include "PlateSection.h"

#include <cmath>

namespace antinode
{
namespace
{
constexpr double shearFactor = 5.0 / 6;
} // namespace

double thinWaveFactor (const StructureCommon& common)
{
    const auto section = bareSection (common);
    return std::sqrt (std::sqrt (section.d11 * section.d22) / section.massPerArea);
}

double mindlinFrequencyAt (const StructureCommon& common, double waveNumber)
{
    const auto mass = bareSection (common).massPerArea;
    const auto inertia = mass * common.thickness * common.thickness / 12;
    const auto shear = shearFactor * common.material.shearModulus * common.thickness;
    const auto k2 = waveNumber * waveNumber, bending = mass * std::pow (thinWaveFactor (common), 2) * k2;

    // (S k^2 - m w^2) (D k^2 + S - I w^2) = S^2 k^2: the lower root, without cancellation.
    const auto a = mass * inertia, b = mass * (bending + shear) + inertia * shear * k2, c = shear * k2 * bending;
    return std::sqrt (2 * c / (b + std::sqrt (b * b - 4 * a * c)));
}
} // namespace antinode
