#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_render/PerformedWaveforms.h>
#include <antinode_structure/DeviceDescription.h>

#include <filesystem>

namespace antinode
{
/** A device as tracks are designed for it and as it judges them: with half as many modes again, where it is solved. */
struct TrackModels
{
    ModalModel known, judge;
};

/** @throws InputError  where the device cannot be solved [worker] */
TrackModels trackModels (const DeviceDescription&, bool usesCache);

/** Writes all files of performed waveforms into a folder, which is made where it is missing.
    @throws InputError  when it cannot be written [worker] Docs/FileFormats.md. */
void writePerformed (const std::filesystem::path&, const PerformedWaveforms&, bool hasReport);
} // namespace antinode
