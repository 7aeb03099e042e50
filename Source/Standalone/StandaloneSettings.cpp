#include "StandaloneSettings.h"

#include "TouchInput.h"

#include <Editor/ContentEditor.h>
#include <antinode_base/InputError.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/System.h>
#include <antinode_base/WholeFile.h>
#include <antinode_documents/Library.h>
#include <antinode_text/JsonReader.h>
#include <antinode_text/JsonText.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <charconv>
#include <system_error>
#include <vector>

namespace antinode
{
namespace
{
constexpr auto schema = "antinode.standalone/1";
constexpr std::size_t longestName = 1000; // bytes
constexpr int maximumBlock = 1 << 16;
constexpr double highestStoredRate = 2e6, maximumVolts = 1e6;

using Json = nlohmann::ordered_json;

/** From what code counts from 0 to what people count from 1; none is 0. */
Json toJsonNumber (int index)
{
    return index + 1;
}

Json audioToJson (const AudioChoice& audio)
{
    auto outputs = Json::array(), inputs = Json::array();

    for (const auto output : audio.outputs)
        outputs.push_back (toJsonNumber (output));

    for (const auto input : audio.inputs)
        inputs.push_back (toJsonNumber (input));

    return { { "type", audio.type },
             { "device", audio.device },
             { "sample_rate_Hz", audio.sampleRate },
             { "block_samples", audio.blockSize },
             { "outputs", outputs },
             { "inputs", inputs } };
}

Json routingToJson (const OutputRouting& routing)
{
    auto outputs = Json::array(), chains = Json::array();

    for (const auto output : routing.outputs)
        outputs.push_back (toJsonNumber (output));

    for (std::size_t i = 0; i < routing.chains.size(); ++i)
        if (const auto& chain = routing.chains[i]; chain != OutputChain {})
            chains.push_back ({ { "output", i + 1 },
                                { "volts_per_full_scale", chain.voltsPerFullScale },
                                { "polarity", chain.polarity } });

    Json json { { "output_of_ceramic", outputs },
                { "monitor_output", toJsonNumber (routing.monitor) },
                { "chains", chains } };

    if (const auto& marker = routing.marker; marker != SyncMarker {})
        json["sync_marker"] = { { "output", toJsonNumber (marker.output) },
                                { "level", marker.level },
                                { "width_ms", marker.seconds * milli } };

    return json;
}

AudioChoice readAudio (const JsonValue& value)
{
    const auto audio = value.object ({ "type", "device", "sample_rate_Hz", "block_samples", "outputs", "inputs" });
    AudioChoice choice { audio.required ("type").text (longestName),
                         audio.required ("device").text (longestName),
                         audio.required ("sample_rate_Hz").number ({ 0, highestStoredRate }),
                         audio.required ("block_samples").integer (0, maximumBlock),
                         {} };

    for (const auto& output : audio.required ("outputs").items (0, OutputRouting::maximumOutputs))
        choice.outputs.push_back (output.integer (1, OutputRouting::maximumOutputs) - 1);

    if (const auto inputs = audio.optional ("inputs"))
        for (const auto& input : inputs->items (0, maximumDeviceOutputs))
            choice.inputs.push_back (input.integer (1, maximumDeviceOutputs) - 1);

    return choice;
}

OutputRouting readRouting (const JsonValue& value)
{
    const auto json = value.object ({ "output_of_ceramic", "monitor_output", "chains", "sync_marker" });
    OutputRouting routing;
    const auto outputs = json.required ("output_of_ceramic").items (routing.outputs.size(), routing.outputs.size());

    for (std::size_t k = 0; k < outputs.size(); ++k)
        routing.outputs[k] = outputs[k].integer (0, OutputRouting::maximumOutputs) - 1;

    routing.monitor = json.required ("monitor_output").integer (0, OutputRouting::maximumOutputs - 1) - 1;

    for (const auto& item : json.required ("chains").items (0, OutputRouting::maximumOutputs))
    {
        const auto chain = item.object ({ "output", "volts_per_full_scale", "polarity" });
        const auto output = chain.required ("output").integer (1, OutputRouting::maximumOutputs) - 1;
        routing.chains[static_cast<std::size_t> (output)] = {
            chain.required ("volts_per_full_scale").number ({ 0, maximumVolts }), chain.required ("polarity").sign()
        };
    }

    if (const auto marker = json.optional ("sync_marker"))
    {
        const auto read = marker->object ({ "output", "level", "width_ms" });
        routing.marker = { read.required ("output").integer (0, OutputRouting::maximumOutputs) - 1,
                           read.required ("level").number ({ 0, 1 }),
                           read.required ("width_ms").number ({ 0, milli }) / milli };
    }

    validate (routing);
    return routing;
}

MidiChoice readMidi (const JsonValue& value)
{
    const auto json = value.object ({ "all", "inputs" });
    MidiChoice midi { json.required ("all").boolean(), {} };

    for (const auto& input : json.required ("inputs").items (0, longestName))
        midi.inputs.push_back (input.text (longestName));

    return midi;
}

Json fingersToJson (const StandaloneSettings& settings)
{
    auto inputs = Json::array();

    for (const auto input : settings.inputs.inputs)
        inputs.push_back (toJsonNumber (input));

    Json json { { "inputs", inputs } };

    if (settings.inputs.sensor != FingerInputs::none)
        json["sensor_input"] = toJsonNumber (settings.inputs.sensor);

    if (settings.touchState)
        json["state"] = Json::parse (stateToText (*settings.touchState, SessionRole::fingers));

    return json;
}

void readFingers (const JsonValue& value, const Json& json, StandaloneSettings& settings)
{
    const auto fingers = value.object ({ "inputs", "sensor_input", "state" });
    const auto inputs =
        fingers.required ("inputs").items (settings.inputs.inputs.size(), settings.inputs.inputs.size());

    for (std::size_t k = 0; k < inputs.size(); ++k)
        settings.inputs.inputs[k] = inputs[k].integer (0, OutputRouting::maximumOutputs) - 1;

    if (const auto sensor = fingers.optional ("sensor_input"))
        settings.inputs.sensor = sensor->integer (1, OutputRouting::maximumOutputs) - 1;

    if (fingers.has ("state"))
        settings.touchState = readState (json["state"].dump(), SessionRole::fingers);
}

Json benchToJson (const BenchSensor& bench)
{
    return { { "sensor_input", toJsonNumber (bench.input) },
             { "sync_input", toJsonNumber (bench.syncInput) },
             { "sensitivity_mm_s_per_V", bench.scale.sensitivity },
             { "input_full_scale_V", bench.scale.inputFullScale } };
}

BenchSensor readBench (const JsonValue& value)
{
    const auto bench = value.object ({ "sensor_input", "sync_input", "sensitivity_mm_s_per_V", "input_full_scale_V" });
    return { bench.required ("sensor_input").integer (1, OutputRouting::maximumOutputs) - 1,
             bench.required ("sync_input").integer (0, OutputRouting::maximumOutputs) - 1,
             { bench.required ("sensitivity_mm_s_per_V").number ({ 0, maximumVolts }),
               bench.required ("input_full_scale_V").number ({ 0, maximumVolts }) } };
}

TouchPorts readTouch (const JsonValue& value)
{
    constexpr int highestPort = 65535;
    const auto json = value.object ({ "osc_port", "tuio_port", "address", "cursors" });
    const auto cursors = json.optional ("cursors");
    return { json.required ("osc_port").integer (0, highestPort), json.required ("tuio_port").integer (0, highestPort),
             json.required ("address").text (longestName), std::string (cursors ? cursors->choice (cursorWords) : "") };
}
} // namespace

std::string settingsToText (const StandaloneSettings& settings)
{
    Json json { { "schema", schema },
                { "audio", audioToJson (settings.audio) },
                { "routing", routingToJson (settings.routing) },
                { "midi", { { "all", settings.midi.all }, { "inputs", settings.midi.inputs } } },
                { "touch",
                  { { "osc_port", settings.touch.oscPort },
                    { "tuio_port", settings.touch.tuioPort },
                    { "address", settings.touch.address },
                    { "cursors", wordFor (cursorWords, std::string_view (settings.touch.finger)) } } },
                { "theme", wordFor (themeWords, settings.isDark) } };

    if (settings.scale > 0)
        json["scale"] = settings.scale;

    if (settings.state)
        json["state"] = Json::parse (stateToText (*settings.state));

    if (settings.touchState || settings.inputs != FingerInputs())
        json["fingers"] = fingersToJson (settings);

    if (settings.bench != BenchSensor())
        json["bench"] = benchToJson (settings.bench);

    return json.dump (2) + "\n";
}

StandaloneSettings readSettings (std::string_view text)
{
    const auto json = parseJson (text, "settings");
    const JsonValue value (json, "settings");
    value.requireSchema (schema);
    const auto object =
        value.object ({ "schema", "audio", "routing", "midi", "touch", "theme", "scale", "state", "fingers", "bench" });
    StandaloneSettings settings { readAudio (object.required ("audio")),
                                  readRouting (object.required ("routing")),
                                  readMidi (object.required ("midi")),
                                  readTouch (object.required ("touch")),
                                  true,
                                  0,
                                  {},
                                  {},
                                  {},
                                  {} };

    if (const auto theme = object.optional ("theme"))
        settings.isDark = theme->choice (themeWords);

    if (const auto scale = object.optional ("scale"))
        settings.scale = scale->number (scaleRange);

    if (object.has ("state"))
        settings.state = readState (json["state"].dump());

    if (const auto fingers = object.optional ("fingers"))
        readFingers (*fingers, json["fingers"], settings);

    if (const auto bench = object.optional ("bench"))
        settings.bench = readBench (*bench);

    return settings;
}

namespace
{
namespace fs = std::filesystem;

constexpr int largestProcess = 1 << 22; // of Linux; what is above is a date, or somebody's count

/** What earlier versions left when they were killed: files beside it that end with the number of a dead process. */
void removeAbandonedCopies (const fs::path& file)
{
    std::error_code ignored;
    const auto start = file.filename().string() + ".";
    std::vector<fs::path> abandoned;

    for (const auto& entry : fs::directory_iterator (file.parent_path(), ignored))
    {
        const auto name = entry.path().filename().string();
        int process = 0;

        if (! name.starts_with (start))
            continue;

        const auto [end, error] = std::from_chars (name.data() + start.size(), name.data() + name.size(), process);

        if (error == std::errc() && end == name.data() + name.size() && process > 0 && process <= largestProcess
            && ! isProcessRunning (process))
            abandoned.push_back (entry.path());
    }

    for (const auto& path : abandoned)
        fs::remove (path, ignored);
}

/** An unused name in the folder of the file. */
fs::path freeName (const fs::path& file)
{
    auto name = file;
    name += ".broken";
    int i = 2;

    for (std::error_code unknown; fs::exists (name, unknown); ++i)
        (name = file) += ".broken-" + std::to_string (i);

    return name;
}
} // namespace

fs::path usualSettingsFile()
{
    const auto folder = userConfigFolder();
    return folder ? *folder / "standalone.json" : fs::path();
}

StandaloneSettings SettingsFile::load()
{
    std::error_code ignored;

    if (file.empty())
        return {};

    removeAbandoned (file.parent_path());
    removeAbandonedCopies (file);

    if (! fs::exists (file, ignored))
        return {};

    try
    {
        auto text = readWholeFile (file, {});
        auto settings = readSettings (text);
        written = std::move (text);
        return settings;
    }
    catch (const InputError& failure)
    {
        putAside (failure.what());
        return {};
    }
}

void SettingsFile::putAside (const std::string& reason)
{
    const auto aside = freeName (file);
    std::error_code failure;
    fs::rename (file, aside, failure);
    loadWarning = "The settings could not be read (" + reason + "), so they ";

    if (failure)
    {
        loadWarning += "remain in " + file.string() + ", and no settings are saved this time.";
        file.clear();
        return;
    }

    loadWarning += "were moved to " + aside.string() + ", and the defaults apply.";
}

void SettingsFile::save (const StandaloneSettings& settings)
{
    auto text = settingsToText (settings);

    if (file.empty() || text == written)
        return;

    try
    {
        writeWholeFile (file, text);
    }
    catch (const InputError&)
    {
        throw InputError (file.string(), "the settings cannot be written");
    }

    written = std::move (text);
}
} // namespace antinode
