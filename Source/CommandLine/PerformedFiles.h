#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_render/PerformedWaveforms.h>

#include <filesystem>

namespace antinode
{
/** What is written besides voltages, sounds and numbers. */
struct PerformedExtras
{
    bool hasReport = true;
    const ModalModel* designFor = nullptr; ///< The device's own modes, where a design.json is wanted.
};

/** Writes all files of performed waveforms into a folder, which is made where it is missing.
    @throws InputError  when it cannot be written [worker] Docs/FileFormats.md. */
void writePerformed (const std::filesystem::path&, const PerformedWaveforms&, const PerformedExtras&);
} // namespace antinode
