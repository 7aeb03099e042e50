#pragma once

#include "SweepPlan.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace antinode
{
/** A plan with the documents that it names, so that nothing else is needed to compute its cases. */
struct SweepInputs
{
    SweepPlan plan;
    nlohmann::json document; ///< The plan's, with the documents of focus or waveforms and device in it.
    std::string hash;        ///< Of this and the version of the program, 32 hexadecimal digits.

    const nlohmann::json& focus() const { return document.at ("focus"); }
    const nlohmann::json& waveforms() const { return document.at ("waveforms"); }

    /** Of a case with this "device"; empty: the one of all cases. [any] */
    const nlohmann::json& device (const std::string& name) const
    {
        return name.empty() ? document.at ("device") : document.at ("devices").at (name);
    }
};

/** A plan and its documents from the plan's document.
    @param file  how errors name it; names of files begin at its folder
    @throws InputError  as readSweepPlan and loadDocument
    [worker] */
SweepInputs sweepInputs (nlohmann::json, const std::filesystem::path& file);

/** A plan and its documents from files; names of files begin at the folder of the plan.
    @throws InputError  as readJsonFile, readSweepPlan and loadDocument
    [worker] */
SweepInputs loadSweep (const std::filesystem::path&);

/** A document of waveforms that needs no other file: each signal of kind "wav" as one of kind "samples". What is no
   such document stays as it is.
    @param source  how errors name it
    @param folder  where the names of recordings begin
    @throws InputError  as readRecording
    [worker] */
nlohmann::json withRecordings (nlohmann::json, const std::string& source, const std::filesystem::path& folder);
} // namespace antinode
