#include "PlateWaves.h"

#include "DescribedCeramic.h"
#include "PlateSection.h"

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
