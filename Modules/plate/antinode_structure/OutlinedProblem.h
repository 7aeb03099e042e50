#pragma once

#include "BendingModes.h"
#include "BendingProblem.h"
#include "DeviceDescription.h"
#include "PlateSection.h"

#include <optional>

namespace antinode
{
/** A section as the solver of outlined plates wants it, SI. [any] */
BendingSection bendingSection (const PlateSection&);

/** What a ceramic adds to a plate of any outline, and where, SI: one patch or several, each with the edges that bend
   the plate and its moment per volt, which are added up. The kind of ceramic decides; the solver knows patches only.
   [any] Docs/Theory.md, section 1.13. */
std::vector<BendingPatch> ceramicPatches (const StructureCommon&, const CeramicDescription&);

/** The bending of an outlined plate in units in which its size, stiffness and mass per area are 1. */
struct OutlinedProblem
{
    BendingProblem problem; ///< Its patches: those of the ceramics, in their order, then the areas.
    std::vector<std::size_t> ceramicOfPatch;
    double length = 0;      ///< The longer side of its extent, m.
    double stiffness = 0;   ///< N m
    double massPerArea = 0; ///< kg/m^2

    /** What an eigenvalue of 1 stands for, 1/s^2. */
    double eigenvalueUnit() const;

    /** What a mass-normalised shape of 1 stands for, kg^-1/2. */
    double shapeUnit() const;
};

/** [any] Docs/Theory.md, section 1.13. */
OutlinedProblem outlinedProblem (const OutlinedPlate&);

/** A plate with the lowest of its modes, in the units of its problem. */
struct OutlinedSolution
{
    OutlinedProblem scaled;
    BendingModes modes;
    ImmersedResolution resolution;      ///< Of the cells that the modes were solved on.
    Eigen::VectorXd angularFrequencies; ///< rad/s
    double waveNumber = 0; ///< Of the shortest waves anywhere at the highest mode, in units of the problem.
};

/** Solves for the given number of flexible modes, for those that the description asks for, or for 100.
    @param accuracy  coarse: the edges of ceramics are not resolved
    @throws InputError  when the plate cannot be solved, saying why
    [worker] Docs/Theory.md, section 1.13. */
OutlinedSolution solveOutlinedModes (const OutlinedPlate&, std::optional<int> modeCount,
                                     ModeAccuracy accuracy = ModeAccuracy::usual);

/** Estimated relative errors of the frequencies of a solution, from a second one on cells that are larger everywhere:
   at corners, holes and patches, too.
    @return  one value a mode, positive
    @throws InputError  where the plate cannot be solved on larger cells
    [worker] Docs/Theory.md, section 1.13. */
Eigen::VectorXd frequencyErrors (const OutlinedSolution&);
} // namespace antinode
