#pragma once

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
} // namespace antinode
