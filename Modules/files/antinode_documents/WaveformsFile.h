#pragma once

#include <antinode_text/JsonReader.h>
#include <antinode_tracks/Waveforms.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace antinode
{
/** A signal of kind "wav". @param folder  where the file's name begins
    @throws InputError  as readWaveFile, and for a channel that it does not have [worker] */
SampledSignal readRecording (const JsonValue&, const std::filesystem::path& folder);

/** Waveforms at touched points from JSON. Docs/FileFormats.md.
    @param source  how errors name it
    @param folder  where the names of recordings begin
    @throws InputError  source, JSON pointer, what is wrong, what is allowed, "did you mean"; what readWaveFile throws
    [worker] */
WaveformsDescription readWaveforms (const nlohmann::json&, const std::string& source,
                                    const std::filesystem::path& folder);
} // namespace antinode
