#include "ExcitationFile.h"

#include <antinode_text/JsonReader.h>
#include <antinode_text/JsonText.h>
#include <antinode_text/WaveFile.h>

namespace antinode
{
namespace
{
constexpr std::string_view schema = "antinode.excitation/1";

constexpr WordList<ExcitationSignal, 3> signalWords { { { "multisine", ExcitationSignal::multisine },
                                                        { "sweep", ExcitationSignal::sweep },
                                                        { "noise", ExcitationSignal::noise } } };

JsonObject sheetObject (const nlohmann::json& document, const std::string& source)
{
    const JsonValue root (document, source);
    root.requireSchema (schema);
    return root.object ({ "schema", "device", "signal", "signal_file", "sample_rate_Hz", "lowest_frequency_Hz",
                          "highest_frequency_Hz", "resolution_Hz", "periods", "settling_periods", "sweep_duration_s",
                          "odd_lines", "seed", "full_scale_V", "ceramics", "turn_samples", "signal_samples",
                          "crest_factor", "lines" });
}

/** Their bounds in detail are those of makeExcitation. */
ExcitationSettings readSettings (const JsonObject& sheet)
{
    constexpr NumberRange frequency { 0, 1e6 }, duration { 0, 1e4 };
    constexpr int maximum = 10000, largestSeed = 2000000000;
    ExcitationSettings settings;
    settings.signal = sheet.required ("signal").choice (signalWords);
    settings.sampleRate = sheet.required ("sample_rate_Hz").number ({ 8000, 2e6 });
    settings.lowestFrequency = sheet.required ("lowest_frequency_Hz").number (frequency);
    settings.highestFrequency = sheet.required ("highest_frequency_Hz").number (frequency);
    settings.resolution = sheet.required ("resolution_Hz").number (frequency);
    settings.periods = sheet.required ("periods").integer (1, maximum);
    settings.settlingPeriods = sheet.required ("settling_periods").integer (1, maximum);
    settings.sweepDuration = sheet.required ("sweep_duration_s").number (duration);
    settings.hasOddGrid = sheet.required ("odd_lines").boolean();
    settings.seed = static_cast<std::uint64_t> (sheet.required ("seed").integer (0, largestSeed));
    return settings;
}

void readCeramics (const JsonObject& sheet, ExcitationSheet& result, ExcitationSettings& settings)
{
    const auto ceramics = sheet.required ("ceramics").items (1, ranges::maximumCeramics);
    const auto count = static_cast<Eigen::Index> (ceramics.size());
    settings.levels.resize (count);
    result.voltageLimits.resize (count);

    for (Eigen::Index i = 0; i < count; ++i)
    {
        const auto ceramic = ceramics[static_cast<std::size_t> (i)].object ({ "name", "level_V", "limit_V" });
        result.ceramics.push_back (ceramic.required ("name").text (ranges::maximumNameBytes));
        settings.levels[i] = ceramic.required ("level_V").number ({ 0, 1e5, true });
        result.voltageLimits[i] = ceramic.required ("limit_V").number (ranges::voltage);
    }
}
} // namespace

nlohmann::ordered_json excitationToJson (const ExcitationSheet& sheet, const std::string& signalFile)
{
    const auto& excitation = sheet.excitation;
    const auto& settings = excitation.settings;
    auto ceramics = nlohmann::ordered_json::array();

    for (Eigen::Index i = 0; i < settings.levels.size(); ++i)
        ceramics.push_back ({ { "name", sheet.ceramics[static_cast<std::size_t> (i)] },
                              { "level_V", settings.levels[i] },
                              { "limit_V", sheet.voltageLimits[i] } });

    return { { "schema", schema },
             { "device", sheet.device },
             { "signal", wordFor (signalWords, settings.signal) },
             { "signal_file", signalFile },
             { "sample_rate_Hz", settings.sampleRate },
             { "lowest_frequency_Hz", settings.lowestFrequency },
             { "highest_frequency_Hz", settings.highestFrequency },
             { "resolution_Hz", settings.resolution },
             { "lines", excitation.lines.size() },
             { "periods", settings.periods },
             { "settling_periods", settings.settlingPeriods },
             { "sweep_duration_s", settings.sweepDuration },
             { "odd_lines", settings.hasOddGrid },
             { "seed", settings.seed },
             { "crest_factor", excitation.crestFactor },
             { "signal_samples", excitation.signal.size() },
             { "turn_samples", excitation.runLength },
             { "full_scale_V", sheet.fullScaleVoltage },
             { "ceramics", ceramics } };
}

std::string readSignalFileName (const nlohmann::json& document, const std::string& source)
{
    const auto value = sheetObject (document, source).required ("signal_file");
    auto name = value.text (ranges::maximumNameBytes);

    if (name.empty() || name.front() == '.' || name.find ('/') != std::string::npos)
        value.fail ("is not a plain file name; allowed: a file in the folder of the sheet");

    return name;
}

ExcitationSheet readExcitation (const nlohmann::json& document, const std::string& source,
                                const Eigen::VectorXd& signal)
{
    const auto object = sheetObject (document, source);
    ExcitationSheet sheet;
    sheet.device = object.required ("device").text (ranges::maximumNameBytes);
    sheet.fullScaleVoltage = object.required ("full_scale_V").number (ranges::voltage);
    auto settings = readSettings (object);
    readCeramics (object, sheet, settings);
    sheet.excitation = excitationWith (settings, sheet.voltageLimits, signal);
    return sheet;
}

namespace
{
constexpr const char* signalFile = "signal.wav";
} // namespace

void writeSheet (OutputFolder& folder, const ExcitationSheet& sheet)
{
    folder.write (signalFile,
                  encodeWave (sheet.excitation.signal.transpose(), 1, sheet.excitation.settings.sampleRate));
    folder.write ("excitation.json", excitationToJson (sheet, signalFile).dump (2) + "\n");
}

ExcitationSheet readSheet (const std::filesystem::path& path)
{
    const auto source = path.string();
    const auto document = readJsonFile (path);
    const auto signal = readWaveFile (path.parent_path() / readSignalFileName (document, source));
    return readExcitation (document, source, signal.samples.row (0));
}
} // namespace antinode
