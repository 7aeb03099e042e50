#include "Perform.h"

#include "Render.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/WholeFile.h>
#include <antinode_documents/DesignFile.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_engine/LagFilters.h>
#include <antinode_learning/RecordingDelays.h>
#include <antinode_render/PerformedWaveforms.h>
#include <antinode_reports/WaveformsReport.h>
#include <antinode_text/CsvTable.h>
#include <antinode_text/OutputFolder.h>
#include <antinode_text/WaveFile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
/** The waveform of each finger as a sound: full scale is the largest displacement of all. */
void writeFingers (OutputFolder& folder, const PerformedWaveforms& performed)
{
    const auto& played = performed.played;
    const auto loudest = played.displacements.cwiseAbs().maxCoeff();

    for (Eigen::Index p = 0; p < played.displacements.rows(); ++p)
        folder.write (formatted ("finger-%02td.wav", p + 1),
                      encodeWave (played.displacements.row (p), loudest, played.sampleRate));
}

/** What the voltages of a file do, 1.0 of which is the device's full scale. */
PerformedWaveforms judgePlayed (const std::filesystem::path& file, const ModalModel& known, const ModalModel& judge,
                                const WaveformsDescription& description, TrackSettings settings,
                                const ShowProgress& show)
{
    const auto wave = readWaveFile (file);
    settings.sampleRate = wave.sampleRate;
    const Eigen::MatrixXd asked = judge.fullScaleVoltage * wave.samples;
    auto performed =
        judgeVoltages (known, judge, description, settings, withLags (judge, asked, wave.sampleRate), show);

    if (needsLagFilters (judge))
        performed.undone = UndoneLags { asked }; // The samples of the file stay.

    return performed;
}
} // namespace

std::vector<Field> fields (PerformRequest& request)
{
    constexpr double milliseconds = 1000;
    std::vector<Field> all {
        Field ("waveforms", &request.waveforms,
               "Waveforms: an embedded name, a .json file or haptic content (AHAP, HJIF, Android's VibrationEffect)")
            .usually ("three-fingers")
            .positional(),
        Field ("--device", &request.device, "Device: an embedded name or a .json file")
            .usually ("glass-148x210")
            .by ("the one that the waveforms name, else glass-148x210")
            .positional(),
    };
    append (all, fields (request.at));
    append (all,
            {
                Field ("--rate", &request.sampleRate, "Sample rate, Hz").as ("sample_rate_Hz").within (1000, 2e6),
                Field ("--latency-ms", &request.latency,
                       "Voltages follow the tracks as live inputs, by filters with this latency, ms, for example 5")
                    .in (milliseconds)
                    .within (0.1, 100)
                    .by ("the whole event is known"),
                Field ("--threshold", &request.thresholdFile, "Threshold of skin: CSV of Hz and um")
                    .by ("the built-in table"),
                Field ("--correct", &request.passes,
                       "Folder of an earlier pass with recorded.csv or recorded.wav in it (repeatable, in order)")
                    .as ("passes")
                    .written ("FOLDER")
                    .without ("--latency-ms"),
                Field ("--longest-latency-ms", &request.longestLatency,
                       "Longest latency of each recording in the search, ms; 0: it begins with its voltages")
                    .in (milliseconds)
                    .within (0, 200)
                    .with ("--correct"),
                cacheField (request.usesCache),
                Field ("--tolerance", &request.hasTolerance,
                       "Plays the voltages on devices that differ from the model: levels and errors at the fingers"),
            });

    for (auto& field : fields (request.devices))
        all.push_back (field.with ("--tolerance"));

    append (all, fields (request.sensor));
    return all;
}

ReachedWaveforms performWithinLimits (const TrackModels& models, WaveformsDescription waveforms,
                                      const TrackSettings& settings)
{
    constexpr double below = 0.999; // the next design is another one
    double share = 1;

    while (true)
    {
        try
        {
            return { performWaveforms (models.known, models.judge, waveforms, settings), share };
        }
        catch (const TrackLimitError& error)
        {
            for (auto& track : waveforms.tracks)
                for (auto& event : track.events)
                    event.amplitude *= below * error.share;

            share *= below * error.share;
        }
    }
}

PerformedWaveforms perform (const PerformRequest& request, const ShowProgress& show)
{
    TrackSettings settings;
    settings.sampleRate = request.sampleRate;
    settings.latency = request.latency.value_or (0);
    settings.threshold = findSkinThreshold (request.thresholdFile.string());

    if (show)
        show ("Modes of the device", 0);

    const auto waveforms = placedWaveforms (request.waveforms, request.at);
    const auto [known, judge] = trackModels (request.device, request.usesCache);
    requirePlaces (judge.surface, waveforms);

    if (! request.played.empty())
        return judgePlayed (request.played, known, judge, waveforms, settings, show);

    const auto passes = withoutLatency (readRecordedPasses (request.passes, known, waveforms.band, request.sensor),
                                        known, waveforms, request.sampleRate, request.longestLatency);
    auto performed = performWaveforms (known, judge, waveforms, settings, show, passes);

    if (request.hasTolerance)
        performed.tolerance = waveformsTolerance (judge, performed.design, settings.threshold,
                                                  toleranceOptions (request.devices, spreadOf (judge.origin)), show);

    return performed;
}

void writePerformed (const std::filesystem::path& path, const PerformedWaveforms& performed,
                     const PerformedExtras& extras)
{
    OutputFolder folder (path);
    folder.write ("voltages.wav", encodeWave (outputVoltages (performed), performed.judge.fullScaleVoltage,
                                              performed.played.sampleRate));
    writeFingers (folder, performed);

    if (performed.tolerance)
        folder.write ("tolerance.csv", toleranceToCsv (*performed.tolerance));

    if (extras.hasReport)
        folder.write ("report.html", renderReport (waveformsReport (performed)));

    if (extras.designFor != nullptr)
        folder.write ("design.json",
                      designToJson (performedDesign (performed, *extras.designFor), *extras.designFor).dump() + "\n");

    const auto summary = performedToJson (performed);
    folder.write ("scores.csv", scoreTable ({ { performed.design.description.name, summaryNumbers (summary), {} } }));
    folder.write ("summary.json", summary.dump (2) + "\n");
    folder.commit();
}

namespace
{
constexpr double sameRate = 1e-3; // times may be rounded

/** The sample of the trigger, from the summary of a pass of so many samples. */
double triggerSample (const std::filesystem::path& path, Eigen::Index samples)
{
    const auto json = nlohmann::json::parse (readWholeFile (path, { "a JSON file" }), nullptr, false);

    if (! json.is_object() || ! json.contains ("trigger_sample") || ! json["trigger_sample"].is_number())
        throw InputError (path.string(), "has no \"trigger_sample\"; allowed: summary.json of antinode perform");

    const auto trigger = json["trigger_sample"].get<double>();

    if (! (trigger >= 0 && trigger < static_cast<double> (samples) && trigger == std::floor (trigger)))
        throw InputError (path.string(), "has the trigger_sample " + inWords (trigger)
                                             + "; allowed: a whole number from 0 to " + std::to_string (samples - 1)
                                             + ", the last sample of voltages.wav");

    return trigger;
}

bool endsWith (const std::string& text, const std::string& end)
{
    return text.size() >= end.size() && text.compare (text.size() - end.size(), end.size(), end) == 0;
}

/** The columns of a table but the time, points x samples, m. */
Eigen::MatrixXd recordedTable (const std::filesystem::path& path, double sampleRate, TrackBand band)
{
    const auto table = readCsvTable (readWholeFile (path, { "a CSV file" }), path.string());
    const auto all = [&] (const char* unit)
    {
        for (std::size_t i = 1; i < table.headings.size(); ++i)
            if (table.headings[i].find (unit) == std::string::npos)
                return false;

        return table.headings.size() > 1;
    };
    const auto isDisplacement = all ("_um");

    if (! isDisplacement && ! all ("_mm_s"))
        throw InputError (path.string(), "has other headings; allowed: headings time_s and then displacement_um_1 "
                                         "or velocity_mm_s_1 and so on");

    for (std::size_t i = 1; i < table.headings.size(); ++i)
        if (const auto number = "_" + std::to_string (i); ! endsWith (table.headings[i], number))
            throw InputError (path.string(), "has '" + table.headings[i] + "' as column " + std::to_string (i + 1)
                                                 + "; allowed: a heading that ends with '" + number
                                                 + "', the finger's number");

    const auto last = table.numbers.rows() - 1;

    if (const auto begin = table.numbers (0, 0); ! (std::abs (begin) * sampleRate < 0.5))
        throw InputError (path.string(),
                          "begins at " + inWords (begin) + " s; allowed: 0 s, with the first sample of voltages.wav");

    if (const auto span = table.numbers (last, 0) - table.numbers (0, 0);
        last > 0 && ! (std::abs (span * sampleRate / static_cast<double> (last) - 1) < sameRate))
        throw InputError (path.string(), "does not have a sample each " + inWords (micro / sampleRate)
                                             + " us in its first column, as voltages.wav has");

    const Eigen::MatrixXd samples = table.numbers.rightCols (table.numbers.cols() - 1).transpose();
    return isDisplacement ? Eigen::MatrixXd (samples / micro) : displacementsOf (samples / milli, sampleRate, band);
}
} // namespace

std::vector<RecordedPass> readRecordedPasses (const std::vector<std::filesystem::path>& folders,
                                              const ModalModel& model, TrackBand band, const SensorScale& sensor)
{
    std::vector<RecordedPass> passes;

    for (std::size_t i = 0; i < folders.size(); ++i)
    {
        const auto& folder = folders[i];

        if (std::find (folders.begin(), folders.begin() + static_cast<std::ptrdiff_t> (i), folder)
            != folders.begin() + static_cast<std::ptrdiff_t> (i))
            throw InputError ("--correct " + folder.string(),
                              "is given twice; allowed: each pass once, in the order of playing");

        const auto wave = readWaveFile (folder / "voltages.wav");
        const auto trigger = triggerSample (folder / "summary.json", wave.samples.cols());
        auto& pass = passes.emplace_back();
        pass.voltages = { { Reconstruction::bandLimited, wave.sampleRate },
                          -trigger / wave.sampleRate,
                          withLags (model, model.fullScaleVoltage * wave.samples, wave.sampleRate) };
        const auto file = recordedFile (folder);
        pass.displacements =
            file.extension() == ".csv"
                ? recordedTable (file, wave.sampleRate, band)
                : displacementsOf (recordedVelocities (file, wave.sampleRate, sensor), wave.sampleRate, band);
    }

    return passes;
}

std::vector<RecordedPass> withoutLatency (std::vector<RecordedPass> passes, const ModalModel& known,
                                          const WaveformsDescription& description, double sampleRate,
                                          double longestLatency)
{
    if (! (longestLatency > 0))
        return passes;

    requirePasses (passes, known, description, sampleRate);

    for (std::size_t i = 0; i < passes.size(); ++i)
    {
        auto& pass = passes[i];

        if (pass.displacements.isZero (0) || pass.voltages.values.isZero (0))
            throw InputError ("recorded pass " + std::to_string (i + 1),
                              "is silent, so no latency can be found; allowed: a pass that was played");

        auto aligned = alignedWith (pass.displacements, predictedDisplacements (known, description, pass.voltages, 0),
                                    sampleRate, longestLatency);
        pass.displacements = std::move (aligned.signals);
        pass.latency = aligned.delay;
    }

    return passes;
}
} // namespace antinode
