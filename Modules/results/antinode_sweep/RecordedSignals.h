#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace antinode
{
/** A document of waveforms that needs no other file: each signal of kind "wav" as one of kind "samples". What is no
   such document stays as it is.
    @param source  how errors name it
    @param folder  where the names of recordings begin
    @throws InputError  as readRecording
    [worker] */
nlohmann::json withRecordings (nlohmann::json, const std::string& source, const std::filesystem::path& folder);
} // namespace antinode
