#pragma once

#include <antinode_tracks/Waveforms.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace antinode
{
/** Waveforms at touched points from JSON. Docs/FileFormats.md.
    @param source  how errors name it
    @param folder  where the names of recordings begin
    @throws InputError  source, JSON pointer, what is wrong, what is allowed, "did you mean"; what readWaveFile throws
    [worker] */
WaveformsDescription readWaveforms (const nlohmann::json&, const std::string& source,
                                    const std::filesystem::path& folder);
} // namespace antinode
