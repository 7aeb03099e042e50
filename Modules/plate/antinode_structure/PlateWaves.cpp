#include "PlateWaves.h"

#include "CeramicShapes.h"
#include "SoftLayers.h"
#include "ThickPlates.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace antinode
{
namespace
{
using std::numbers::pi;

double softerStiffness (const PlateSection& section)
{
    return std::min (section.d11, section.d22);
}

double computeWaveNumber (const PlateSection& section, double angularFrequency)
{
    return std::sqrt (angularFrequency * std::sqrt (section.massPerArea / softerStiffness (section)));
}

/** What an edge takes from the area's share of modes, in units of the edge's length times k / (4 pi). */
double edgeTerm (EdgeCondition condition)
{
    return condition == EdgeCondition::clamped ? 1.8 : condition == EdgeCondition::simplySupported ? 1.0 : 0.0;
}

/** The area of a bare plate with as many modes: waves are longer on ceramics. */
double equivalentArea (const PlateDescription& plate, const PlateSection& bare)
{
    const auto density = [] (const PlateSection& s) { return std::sqrt (s.massPerArea / std::sqrt (s.d11 * s.d22)); };
    auto area = plate.lengthX * plate.lengthY * density (bare);

    for (const auto& ceramic : plate.common.ceramics)
        area += faceArea (ceramic) * (density (ceramicSection (plate.common, ceramic)) - density (bare));

    return area / std::sqrt (bare.massPerArea / softerStiffness (bare));
}

double lowestAcross (EdgeCondition a, EdgeCondition b, double length)
{
    const auto held = (a != EdgeCondition::free ? 1 : 0) + (b != EdgeCondition::free ? 1 : 0);
    return held == 0 ? 0 : held == 1 ? pi / length : 1.6 * pi / length;
}

/** So many modes of one beam-like family lie below this: no plate has fewer. */
double stripWaveNumber (const PlateDescription& plate, int modeCount)
{
    const auto alongX =
        std::hypot ((modeCount + 2) * pi / plate.lengthX, lowestAcross (plate.bottom, plate.top, plate.lengthY));
    const auto alongY =
        std::hypot ((modeCount + 2) * pi / plate.lengthY, lowestAcross (plate.left, plate.right, plate.lengthX));
    return std::min (alongX, alongY);
}

/** By how much thin-plate theory exceeds Mindlin's, relative, for small k h. */
double excess (double waveNumber, double thickness, double poissonRatio)
{
    constexpr double shearFactor = 5.0 / 6;
    const auto relative = waveNumber * thickness;
    return relative * relative / 24 * (1 + 2 / (shearFactor * (1 - poissonRatio)));
}

/** The largest excess anywhere on the plate: of the substrate, or of a ceramic's section with its longer waves. */
double largestExcess (const StructureCommon& common, double angularFrequency)
{
    const auto poissonRatio = common.material.poissonRatio12;
    auto largest = excess (waveNumberAt (common, angularFrequency), common.thickness, poissonRatio);

    for (const auto& ceramic : common.ceramics)
    {
        const auto waveNumber = computeWaveNumber (ceramicSection (common, ceramic), angularFrequency);
        const auto sides = ceramic.mounting == CeramicMounting::bothSides ? 2 : 1;
        largest = std::max (largest, excess (waveNumber, common.thickness + sides * ceramic.thickness, poissonRatio));
    }

    return largest;
}
} // namespace

double waveNumberAt (const StructureCommon& common, double angularFrequency)
{
    return computeWaveNumber (bareSection (common), angularFrequency);
}

double largestWaveNumberAt (const StructureCommon& common, double angularFrequency)
{
    auto largest = waveNumberAt (common, angularFrequency);

    for (const auto& ceramic : common.ceramics)
        largest = std::max (largest, computeWaveNumber (ceramicSection (common, ceramic), angularFrequency));

    return largest;
}

double angularFrequencyAt (const StructureCommon& common, double waveNumber)
{
    const auto section = bareSection (common);
    return waveNumber * waveNumber * std::sqrt (softerStiffness (section) / section.massPerArea);
}

double expectedWaveNumber (const PlateDescription& plate, int modeCount)
{
    const auto edges = plate.lengthY * (edgeTerm (plate.left) + edgeTerm (plate.right))
                       + plate.lengthX * (edgeTerm (plate.bottom) + edgeTerm (plate.top));
    const auto area = equivalentArea (plate, bareSection (plate.common));
    const auto weyl = (edges / 2 + std::sqrt (edges * edges / 4 + 16 * pi * area * (modeCount + 1))) / (2 * area);
    return std::min (weyl, stripWaveNumber (plate, modeCount));
}

std::vector<std::string> thicknessWarnings (const StructureCommon& common, const Eigen::VectorXd& angularFrequencies)
{
    constexpr double tolerable = 0.02;
    const auto first = std::find_if (angularFrequencies.begin(), angularFrequencies.end(),
                                     [&] (double omega) { return largestExcess (common, omega) > tolerable; });

    if (first == angularFrequencies.end() || hasSoftLayers (common))
        return {};

    const auto count = static_cast<int> (angularFrequencies.size());
    const auto highest = angularFrequencies[count - 1];
    const auto waveNumber = waveNumberAt (common, highest);
    std::array<char, 500> text {};

    if (common.theory == BendingTheory::thick)
        std::snprintf (text.data(), text.size(),
                       "Frequencies are corrected for the thickness: that of mode %d from %.0f to %.0f Hz. Where edges "
                       "are clamped, or on ceramics, up to half of the correction is missing.",
                       count, highest / (2 * pi),
                       mindlinFrequencyAt (common, std::sqrt (highest / thinWaveFactor (common))) / (2 * pi));
    else
        std::snprintf (
            text.data(), text.size(),
            "From mode %d (%.0f Hz) on, waves are so short compared with the thickness that thin-plate theory "
            "overestimates frequencies by more than 2 %%; at mode %d (%.0f Hz), where a wave is %.1f thicknesses of "
            "the bare plate long, by about %.0f %%. \"theory\": \"mindlin\" in the device corrects them.",
            static_cast<int> (first - angularFrequencies.begin()) + 1, *first / (2 * pi), count, highest / (2 * pi),
            2 * pi / (waveNumber * common.thickness), 100 * largestExcess (common, highest));

    return { text.data() };
}
} // namespace antinode
