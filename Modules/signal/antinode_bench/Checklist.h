#pragma once

#include "AudioBench.h"

#include <antinode_documents/ExcitationFile.h>
#include <antinode_model/ModalModel.h>

#include <string>

namespace antinode
{
/** What to connect, to check with meter and scope, and to expect, before a device is measured: numbered steps with the
   numbers of this device, lines of text.
    @param points  N_p x 2, m; the first is where the sensor's signal is predicted
    @throws InputError  where the first point lies outside the surface, or as simulateBench
    [worker] Docs/Manual/measuring.md. */
std::string benchChecklist (const ModalModel&, const ExcitationSheet&, const Eigen::MatrixX2d& points,
                            const BenchChannels&, const SensorScale&);
} // namespace antinode
