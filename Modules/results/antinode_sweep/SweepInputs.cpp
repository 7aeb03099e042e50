#include "SweepInputs.h"

#include "PartFolder.h"

#include <antinode_documents/HapticContent.h>
#include <antinode_documents/Inputs.h>
#include <antinode_documents/WaveformsFile.h>
#include <antinode_text/JsonText.h>

#include <nlohmann/json.hpp>

#include <utility>
#include <vector>

namespace antinode
{
namespace
{
constexpr auto usualDevice = "staple", usualTrackDevice = "glass-148x210";

/** What the library takes: a file's name begins at the plan's folder. */
std::string nameFrom (const nlohmann::json& json, const std::filesystem::path& plan)
{
    const auto name = json.get<std::string>();
    return isFileName (name) ? (plan.parent_path() / name).string() : name;
}

/** The document itself, or that of a name, which it gets where it has none; with its recordings and haptic content in
    it. */
nlohmann::json playedDocument (LibraryKind kind, const nlohmann::json& json, const std::filesystem::path& plan)
{
    const auto name = json.is_object() ? plan.string() : nameFrom (json, plan);
    auto document = json.is_object() ? json : loadDocument (kind, name);

    if (json.is_string() && document.is_object() && ! document.contains ("name"))
        document["name"] = std::filesystem::path (name).stem().string();

    if (kind == LibraryKind::focus)
        return document;

    const auto source = json.is_object() ? name : documentSource (kind, name);
    const auto folder = std::filesystem::path (name).parent_path();
    return withRecordings (withHapticFiles (std::move (document), folder), source, folder);
}

nlohmann::json variedDocuments (const SweepPlan& plan, const std::filesystem::path& file)
{
    nlohmann::json documents;

    for (const auto& name : plan.variedDevices())
        documents[name] = plan.devices.is_object() && plan.devices.contains (name)
                              ? plan.devices[name]
                              : loadDocument (LibraryKind::device, nameFrom (name, file));

    return documents;
}

nlohmann::json deviceDocument (const SweepPlan& plan, const std::filesystem::path& file)
{
    if (plan.device.is_object())
        return plan.device;

    if (plan.device.is_string())
        return loadDocument (LibraryKind::device, nameFrom (plan.device, file));

    const auto kind = plan.isOfWaveforms() ? LibraryKind::waveforms : LibraryKind::focus;
    const auto& played = plan.isOfWaveforms() ? plan.waveforms : plan.focus;
    const auto named = played.is_string() ? namedDevice (kind, nameFrom (played, file), {}) : std::string();
    const auto* const usual = plan.isOfWaveforms() ? usualTrackDevice : usualDevice;
    return loadDocument (LibraryKind::device, named.empty() ? usual : named);
}
} // namespace

SweepInputs sweepInputs (nlohmann::json document, const std::filesystem::path& file)
{
    SweepInputs inputs;
    inputs.document = std::move (document);
    inputs.plan = readSweepPlan (inputs.document, file.string());
    auto devices = variedDocuments (inputs.plan, file);
    const auto device = devices.is_null() ? deviceDocument (inputs.plan, file) : nlohmann::json();

    if (inputs.plan.isOfWaveforms())
        inputs.document["waveforms"] = playedDocument (LibraryKind::waveforms, inputs.plan.waveforms, file);
    else
        inputs.document["focus"] = playedDocument (LibraryKind::focus, inputs.plan.focus, file);

    if (devices.is_null())
        inputs.document["device"] = device;
    else
        inputs.document["devices"] = std::move (devices);

    inputs.hash = hashOf (inputs.document.dump());
    return inputs;
}

SweepInputs loadSweep (const std::filesystem::path& file)
{
    return sweepInputs (readJsonFile (file), file);
}

namespace
{
/** The signal of a track or an event, where it is a recording. */
void embedRecording (nlohmann::json& event, const std::string& source, const std::filesystem::path& folder)
{
    if (! event.is_object() || ! event.contains ("signal") || ! event["signal"].is_object()
        || event["signal"].value ("kind", nlohmann::json()) != "wav")
        return;

    const auto recorded = readRecording (JsonValue (event["signal"], source), folder);
    event["signal"] = { { "kind", "samples" },
                        { "sample_rate_Hz", recorded.sampleRate },
                        { "values", std::vector<double> (recorded.samples.begin(), recorded.samples.end()) } };
}
} // namespace

nlohmann::json withRecordings (nlohmann::json document, const std::string& source, const std::filesystem::path& folder)
{
    if (! document.is_object() || ! document.contains ("tracks") || ! document["tracks"].is_array())
        return document;

    for (auto& track : document["tracks"])
    {
        embedRecording (track, source, folder);

        if (track.is_object() && track.contains ("events") && track["events"].is_array())
            for (auto& event : track["events"])
                embedRecording (event, source, folder);
    }

    return document;
}
} // namespace antinode
