#pragma once

#include <antinode_model/ModalModel.h>

#include <string>

namespace antinode
{
/** The modes of a model as a Universal File (ASCII), as modal analysis programs read it: data sets 151 header, 164 units (SI), 15
    nodes, 82 trace lines, and a 55 a mode with its frequency, damping ratio and mass-normalised shape.

    Nodes and modes are numbered from 1, as the format asks. It has six significant digits; what a mode gives for a volt has no
    place in it. No dates are written: the same model gives the same bytes.
    @throws InputError  when a number is not finite
    [worker] Docs/FileFormats.md; SDRC universal data sets, https://www.ceas3.uc.edu/sdrluff. */
std::string encodeUniversalFile (const ModalModel&);
} // namespace antinode
