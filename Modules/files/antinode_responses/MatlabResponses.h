#pragma once

#include "CsvResponses.h"
#include "MatlabFile.h"

namespace antinode
{
/** Frequency responses from arrays of a MATLAB file (responseArrays) of which one size is the number of frequencies;
   the larger of the others counts points, the smaller references. Of several arrays, those whose names differ in
   numbers are read together, a variable per point (H1, H2 ...) or per point and reference (H1_2); else the one called
   H, FRF ..., or the only one that is no spectrum. Places: points, xyz, nodes ... (N_p x 2 or 3), in m, or mm where the
   name ends in _mm. Units: text in `unit`, `quantity` or a `label` in the same structure.
    @param form   the two real numbers of a response where there are no complex ones
    @param names  variables to read; empty: as above
    @throws InputError  when these are not found: which variables there are, what is allowed
    [worker] Docs/FileFormats.md. */
MeasurementFile measurementFromMatlab (const std::vector<MatlabVariable>&, const std::string& source, CsvForm form,
                                       const std::vector<std::string>& names);
} // namespace antinode
