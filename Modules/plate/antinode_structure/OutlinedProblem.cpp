#include "OutlinedProblem.h"

#include "BendingProblem.h"
#include "CeramicBond.h"
#include "DeviceDescription.h"
#include "PlateWaves.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
BendingPatch patchOf (const CeramicDescription& ceramic)
{
    switch (ceramic.shape)
    {
        case CeramicShape::rectangle:
            return rectanglePatch (ceramic.centre(), { ceramic.sizeX, ceramic.sizeY }, ceramic.angle);
        case CeramicShape::disc:
            return discPatch (ceramic.centre(), ceramic.sizeX / 2);
        case CeramicShape::ring:
            return ringPatch (ceramic.centre(), ceramic.sizeX / 2, ceramic.innerDiameter / 2);
    }

    return {};
}

/** What one section has more than another. */
BendingSection difference (const LayeredSection& with, const LayeredSection& without)
{
    return { (with.stiffness - without.stiffness).real(), with.massPerArea - without.massPerArea };
}
} // namespace

BendingSection bendingSection (const PlateSection& section)
{
    BendingSection result;
    result.stiffness << section.d11, section.d12, 0, section.d12, section.d22, 0, 0, 0, section.d66;
    result.massPerArea = section.massPerArea;
    return result;
}

std::vector<BendingPatch> ceramicPatches (const StructureCommon& common, const CeramicDescription& ceramic)
{
    const auto with = sectionWith (common, ceramic, ceramic.angle);
    auto patch = patchOf (ceramic);

    if (! ceramic.carrier)
    {
        const auto bond = ceramicBond (common, ceramic, ceramic.angle);
        const auto& everywhere = bond ? bond->loose : with;
        patch.added = difference (everywhere, bareStack (common));
        patch.added.rotaryInertia = addedRotaryInertia (common, ceramic);
        patch.moment = everywhere.momentPerVolt.real();

        if (bond)
            patch.bonded = bond->part;

        return { patch };
    }

    // With larger cells than on other patches frequencies change by 1e-5, and there may be dozens of benders.
    constexpr double coarser = 1.4;
    const auto carrier = sectionWith (common, ceramic, 0, { false, true });
    const auto bond = ceramicBond (common, ceramic, 0, false);
    auto inner = discPatch (ceramic.centre(), ceramic.carrier->ceramicDiameter / 2);
    auto driven = discPatch (ceramic.centre(), ceramic.carrier->electrodeDiameter / 2);
    patch.added = difference (bond ? bond->loose : carrier, bareStack (common));
    patch.added.rotaryInertia = addedRotaryInertia (common, ceramic, false);
    inner.added = difference (with, carrier);
    inner.added.rotaryInertia = addedRotaryInertia (common, ceramic) - patch.added.rotaryInertia;

    if (bond)
        patch.bonded = bond->part;

    patch.kinks.front().width = inner.kinks.front().width = coarser * ceramic.sizeX / 2;
    driven.moment = with.momentPerVolt.real();
    driven.kinks.clear(); // Only what stiffens bends a mode.
    return { patch, inner, driven };
}

namespace
{
EdgeSupport supportOf (const PlateEdge& edge)
{
    const auto isClamped = edge.condition == EdgeCondition::clamped;
    return { isClamped || edge.condition == EdgeCondition::simplySupported, isClamped, edge.translation,
             edge.rotation };
}

BendingPatch areaPatch (const PlateArea& area)
{
    BendingPatch patch;
    patch.outline = area.outline;
    patch.added.massPerArea = area.massPerArea;
    patch.foundation = area.stiffness;
    return patch;
}

/** The problem in SI, and which ceramic a patch belongs to. */
OutlinedProblem inSi (const OutlinedPlate& plate)
{
    OutlinedProblem result;
    auto& problem = result.problem;
    problem.outline = plate.outline;
    problem.section = bendingSection (bareSection (plate.common));
    problem.foundation = plate.foundation;
    std::transform (plate.edges.begin(), plate.edges.end(), std::back_inserter (problem.edges), supportOf);

    for (std::size_t i = 0; i < plate.common.ceramics.size(); ++i)
        for (auto& patch : ceramicPatches (plate.common, plate.common.ceramics[i]))
        {
            problem.patches.push_back (std::move (patch));
            result.ceramicOfPatch.push_back (i);
        }

    std::transform (plate.areas.begin(), plate.areas.end(), std::back_inserter (problem.patches), areaPatch);

    for (const auto& point : plate.points)
        problem.points.push_back ({ { point.x, point.y }, point.stiffness, point.mass });

    return result;
}

void divide (KinkFunction& kink, double length)
{
    kink.centre /= length;
    kink.value /= length;
    kink.curvature *= length;
    kink.width /= length;
}

/** Changes everything to the units that are given. */
void scale (BendingProblem& problem, double length, double stiffness, double massPerArea)
{
    const auto perFoundation = std::pow (length, 4) / stiffness;
    problem.outline = scaled (problem.outline, 1 / length);
    problem.section.stiffness /= stiffness;
    problem.section.massPerArea /= massPerArea;
    problem.foundation *= perFoundation;

    for (auto& edge : problem.edges)
    {
        edge.translation *= std::pow (length, 3) / stiffness;
        edge.rotation *= length / stiffness;
    }

    for (auto& patch : problem.patches)
    {
        patch.outline = scaled (patch.outline, 1 / length);
        patch.added.stiffness /= stiffness;
        patch.added.massPerArea /= massPerArea;
        patch.added.rotaryInertia /= massPerArea * length * length;
        patch.foundation *= perFoundation;

        if (patch.bonded)
            patch.bonded = scaledPart (*patch.bonded, length, stiffness);

        for (auto& kink : patch.kinks)
            divide (kink, length);
    }

    for (auto& point : problem.points)
    {
        point.place /= length;
        point.stiffness *= length * length / stiffness;
        point.mass /= massPerArea * length * length;
    }
}

/** Modes and what they were resolved by. */
struct ResolvedModes
{
    BendingModes modes;
    ImmersedResolution resolution;
};

ResolvedModes solveFor (const OutlinedProblem& scaled, int count, ModeAccuracy accuracy)
{
    const auto resolution = resolutionFor (scaled.problem, count, accuracy);
    return { bendingModes (scaled.problem, count, resolution), resolution };
}

ResolvedModes firstModes (ResolvedModes resolved, Eigen::Index count)
{
    auto& modes = resolved.modes;
    modes.eigenvalues.conservativeResize (count);
    modes.coefficients.conservativeResize (Eigen::NoChange, count);
    modes.participation.conservativeResize (count, Eigen::NoChange);
    return resolved;
}

/** About how many modes lie below a wave number: the inverse of expectedWaveNumber. */
int expectedCount (const BendingProblem& problem, double waveNumber)
{
    auto count = 1;

    while (count <= maximumPlateModes && expectedWaveNumber (problem, count) < waveNumber)
        count += 1 + count / 50;

    return count;
}

/** All modes up to a frequency: as many as are expected, then more until one lies above it. */
ResolvedModes modesUpTo (const OutlinedPlate& plate, const OutlinedProblem& scaled, double frequency,
                         ModeAccuracy accuracy)
{
    const auto omega = 2 * std::numbers::pi * frequency;
    const auto limit = omega * omega / scaled.eigenvalueUnit();
    auto wanted = expectedCount (scaled.problem, waveNumberAt (plate.common, omega) * scaled.length) + 2;

    for (;; wanted += 4 + wanted / 4)
    {
        auto resolved = solveFor (scaled, std::min (wanted, maximumPlateModes + 1), accuracy);
        const auto& eigenvalues = resolved.modes.eigenvalues;
        const auto below = (eigenvalues.array() <= limit).count();

        if (below == 0)
            throw InputError ("device", "has no mode up to its maximum frequency; choose a higher frequency");

        if (below > maximumPlateModes)
            throw InputError ("device", "maximum frequency is " + std::to_string (frequency)
                                            + " Hz; allowed: above 0 Hz, with up to "
                                            + std::to_string (maximumPlateModes) + " modes below it");

        if (below < eigenvalues.size())
            return firstModes (std::move (resolved), below);
    }
}

ResolvedModes wantedModes (const OutlinedPlate& plate, const OutlinedProblem& scaled, std::optional<int> argument,
                           ModeAccuracy accuracy)
{
    const auto given = argument ? argument : plate.common.modeCount;

    if (! given && plate.common.maximumFrequency)
        return modesUpTo (plate, scaled, *plate.common.maximumFrequency, accuracy);

    requirePlateModes (given.value_or (defaultPlateModes));
    return solveFor (scaled, given.value_or (defaultPlateModes), accuracy);
}
} // namespace

double OutlinedProblem::eigenvalueUnit() const
{
    return stiffness / massPerArea / std::pow (length, 4);
}

double OutlinedProblem::shapeUnit() const
{
    return 1 / (std::sqrt (massPerArea) * length);
}

OutlinedProblem outlinedProblem (const OutlinedPlate& plate)
{
    auto result = inSi (plate);
    result.length = extentOf (plate.outline).size().maxCoeff();
    result.stiffness = result.problem.section.stiffness.diagonal().maxCoeff();
    result.massPerArea = result.problem.section.massPerArea;
    scale (result.problem, result.length, result.stiffness, result.massPerArea);
    return result;
}

namespace
{
/** Leaves the kinks that move frequencies by more than some percent, of patches much stiffer than the plate, and that
   need no functions of their own: those along an axis. */
void keepStrongBends (BendingProblem& problem)
{
    constexpr double much = 4;

    for (auto& patch : problem.patches)
    {
        const auto added = patch.added.stiffness (0, 0) + (patch.bonded ? patch.bonded->stiffness (0, 0) : 0);
        std::erase_if (patch.kinks, [&] (const KinkFunction& kink)
                       { return ! kink.isAlongAxis() || added < much * problem.section.stiffness (0, 0); });
    }
}
} // namespace

OutlinedSolution solveOutlinedModes (const OutlinedPlate& plate, std::optional<int> modeCount, ModeAccuracy accuracy)
{
    auto scaled = outlinedProblem (plate);

    if (accuracy == ModeAccuracy::coarse)
        keepStrongBends (scaled.problem);

    auto [modes, resolution] = wantedModes (plate, scaled, modeCount, accuracy);
    Eigen::VectorXd angularFrequencies = (modes.eigenvalues * scaled.eigenvalueUnit()).cwiseSqrt();
    const auto highest = angularFrequencies[angularFrequencies.size() - 1];
    const auto waveNumber = largestWaveNumberAt (plate.common, highest) * scaled.length;
    return { std::move (scaled), std::move (modes), resolution, std::move (angularFrequencies), waveNumber };
}

namespace
{
/** Cells by a factor larger everywhere: those at corners are shares of the largest. */
ImmersedResolution coarserThan (ImmersedResolution resolution)
{
    constexpr double factor = 1.4;
    resolution.cell *= factor;
    resolution.holeCell *= factor;
    resolution.patchCell *= factor;
    return resolution;
}

/** What Nitsche's penalty leaves on cells of any size: measured, Docs/Design/outlines.md. */
double leftByPenalty (const BendingProblem& problem)
{
    constexpr double rounding = 1e-9, ofDisplacement = 2e-8, ofSlope = 5e-7;
    double left = rounding;

    for (const auto& edge : problem.edges)
        left = std::max (left, edge.holdsSlope ? ofSlope : edge.holdsDisplacement ? ofDisplacement : rounding);

    return left;
}
} // namespace

Eigen::VectorXd frequencyErrors (const OutlinedSolution& solution)
{
    const auto& fine = solution.modes.eigenvalues;
    const auto coarse =
        bendingModes (solution.scaled.problem, static_cast<int> (fine.size()), coarserThan (solution.resolution))
            .eigenvalues;
    const auto differences = (coarse.cwiseQuotient (fine).cwiseSqrt().array() - 1).abs();
    return (differences + leftByPenalty (solution.scaled.problem)).matrix();
}
} // namespace antinode
