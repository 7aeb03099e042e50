#pragma once

#include "PlateSection.h"

#include <string>
#include <vector>

namespace antinode
{
/** The wave number of bending waves on the bare plate, rad/m; of an orthotropic one along its softer direction. [any]
 */
double waveNumberAt (const StructureCommon&, double angularFrequency);

/** That of the shortest waves anywhere: of the bare plate, or of a ceramic that is heavier than it is stiff, rad/m.
    [any] */
double largestWaveNumberAt (const StructureCommon&, double angularFrequency);

/** The reverse of waveNumberAt, rad/s. [any] */
double angularFrequencyAt (const StructureCommon&, double waveNumber);

/** A wave number, rad/m, that the given number of modes hardly exceeds: Weyl's law with its term for the edges, and for
   narrow plates the modes of a strip. [any] Docs/Theory.md, section 1.6. */
double expectedWaveNumber (const PlateDescription&, int modeCount);

/** A warning where waves are so short compared with the thickness that thin-plate theory overestimates frequencies, or
    by how much they are corrected; empty if it is right to 2 %, and for laminates that shear in soft layers.
    @param angularFrequencies  of the modes, ascending
    [any] Docs/Theory.md, section 1.7; Mindlin, J. Appl. Mech. 18 (1951) 31-38. */
std::vector<std::string> thicknessWarnings (const StructureCommon&, const Eigen::VectorXd& angularFrequencies);
} // namespace antinode
