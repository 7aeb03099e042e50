#include "RecordedSignals.h"

#include <antinode_documents/WaveformsFile.h>

#include <nlohmann/json.hpp>

#include <vector>

namespace antinode
{
namespace
{
bool isRecording (const nlohmann::json& track)
{
    return track.is_object() && track.contains ("signal") && track["signal"].is_object()
           && track["signal"].contains ("kind") && track["signal"]["kind"] == "wav";
}
} // namespace

nlohmann::json withRecordings (nlohmann::json document, const std::string& source, const std::filesystem::path& folder)
{
    if (! document.is_object() || ! document.contains ("tracks") || ! document["tracks"].is_array())
        return document;

    for (auto& track : document["tracks"])
        if (isRecording (track))
        {
            const auto recorded = readRecording (JsonValue (track["signal"], source), folder);
            track["signal"] = { { "kind", "samples" },
                                { "sample_rate_Hz", recorded.sampleRate },
                                { "values", std::vector<double> (recorded.samples.begin(), recorded.samples.end()) } };
        }

    return document;
}
} // namespace antinode
