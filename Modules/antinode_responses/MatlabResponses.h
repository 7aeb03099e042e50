#pragma once

#include "MatlabFile.h"
#include "MeasuredResponse.h"

namespace antinode
{
/** Frequency responses from variables of a MATLAB file: a vector of frequencies (f, freq, frequency, in Hz; w, omega in
   rad/s; or the only one that ascends and fits, in Hz) and a complex array (H, FRF, ... or the only one that fits) of
   which one size is the number of frequencies; the larger of the others counts points, the smaller references. Places:
   points, xyz, nodes ... (N_p x 2 or 3), in m, or mm where the name ends in _mm. Units: text in `unit` or `quantity`.
    @throws InputError  when these are not found: which variables there are, what is allowed
    [worker] Docs/FileFormats.md. */
MeasurementFile measurementFromMatlab (const std::vector<MatlabVariable>&, const std::string& source);
} // namespace antinode
