#pragma once

#include <antinode_focus/FocusDesign.h>
#include <antinode_model/ModalModel.h>

#include <string>

namespace antinode
{
/** The modes of a model as CSV, one row per mode: mode (from 1), frequency_Hz, damping_ratio, error_estimate_relative
   (empty if it is not known), and one column participation_NAME_per_V a ceramic; 17 significant digits, so that every
   number reads back to the same bits.
    @throws InputError  when a number is not finite
    [worker] Docs/FileFormats.md. */
std::string encodeModeTable (const ModalModel&);

/** The modes of a model as a MATLAB file: frequency_Hz, damping_ratio (N_m x 1), participation_per_V (N_m x N_b), shape
    (N_p x N_m, kg^-1/2), points_mm (N_p x 2), mass_kg (N_p x 1). Complex modes are complex.
    @throws InputError  as encodeMatlabFile
    [worker] Docs/FileFormats.md. */
std::string encodeModesForMatlab (const ModalModel&);

/** What design.json says of drives and allocation as a MATLAB file: allocation_V (N_b x N_d), a column of N_d numbers
    for each key of an oscillation, samples_V where there are some, voltage_limits_V, fields at points.
    @throws InputError  as encodeMatlabFile
    [worker] Docs/FileFormats.md. */
std::string encodeDesignForMatlab (const FocusDesign&, const ModalModel&);
} // namespace antinode
