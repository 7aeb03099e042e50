#pragma once

#include "MeasuredStructure.h"

#include <antinode_identification/IdentifiedModel.h>

namespace antinode::test
{
/** A known structure as a device that knows itself. */
inline ModalModel makeModel (const KnownStructure& structure)
{
    IdentifiedModes modes;
    modes.points = structure.points;
    modes.angularFrequencies = 2 * std::numbers::pi * structure.frequencies;
    modes.dampingRatios = structure.dampingRatios;
    modes.shapes = structure.shapes;
    modes.participation = structure.participation;
    modes.reconstructionError = -120;
    modes.deviations.angularFrequencies = Eigen::VectorXd::Zero (structure.frequencies.size());

    for (Eigen::Index i = 0; i < structure.participation.cols(); ++i)
        modes.references.push_back ({ "C" + std::to_string (i + 1), {} });

    MappedSurface surface;
    surface.name = "beam";
    surface.masses = structure.masses;
    return toModalModel (modes, surface);
}
} // namespace antinode::test
