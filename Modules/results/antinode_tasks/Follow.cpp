#include "Follow.h"

#include "DeviceChecks.h"
#include "LearnFiles.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_documents/Library.h>
#include <antinode_documents/MeasuredDevice.h>
#include <antinode_engine/LagFilters.h>
#include <antinode_focus/SpillOver.h>
#include <antinode_learning/PlayedRecording.h>
#include <antinode_model/ModalModel.h>
#include <antinode_reports/Report.h>
#include <antinode_text/CsvText.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
Eigen::Index sensorCount (const FollowRequest& request, const ModalModel& model)
{
    if (request.idleCeramic < 0 || request.idleCeramic > model.actuators())
        throw InputError ("--idle-ceramic", "is " + std::to_string (request.idleCeramic) + "; allowed: 1 to "
                                                + std::to_string (model.actuators()));

    const auto count = request.places.rows() + (request.idleCeramic > 0 ? 1 : 0);

    if (count == 0)
        throw InputError ("follow", "has no sensor; allowed: --sensors, --idle-ceramic or both");

    return count;
}

std::vector<Sensor> sensorsOf (const FollowRequest& request, const ModalModel& model)
{
    std::vector<Sensor> sensors;
    const auto shapes = shapesAtPlaces (model, request.places);

    for (Eigen::Index m = 0; m < shapes.rows(); ++m)
        sensors.push_back ({ shapes.row (m) });

    // By reciprocity an idle ceramic's current.
    if (request.idleCeramic > 0)
        sensors.push_back ({ model.participation.col (request.idleCeramic - 1).transpose() });

    return sensors;
}

DriftSettings settingsOf (const FollowRequest& request, const ModalModel& model, const std::vector<Sensor>& sensors)
{
    DriftSettings settings;
    settings.spread.drift = request.drift;
    settings.spread.frequency = request.scatter;
    settings.spread.damping = request.damping;
    settings.spread.gain = request.gain;
    settings.spread.feedthrough = request.feedthrough.value_or (usualFeedthrough (model, sensors));
    settings.memory = request.memory;
    settings.largestJump = request.largestJump;
    return settings;
}

/** Recorded signals that were given as arrays. @throws InputError  where they do not fit the device */
PlayedRecording givenRecording (const FollowRequest& request, const ModalModel& model, Eigen::Index sensors)
{
    const auto check = [] (const char* name, const Eigen::MatrixXd& given, Eigen::Index wanted, const char* each)
    {
        if (given.rows() != wanted)
            throw InputError (name, "has " + std::to_string (given.rows())
                                        + " rows; allowed: " + std::to_string (wanted) + ", one per " + each);
    };
    check ("voltages_V", *request.voltages, model.actuators(), "ceramic");
    check ("signals", *request.signals, sensors, "sensor");
    const auto samples = std::min (request.voltages->cols(), request.signals->cols());
    return { *request.sampleRate,
             withLags (model, request.voltages->leftCols (samples), *request.sampleRate),
             request.signals->leftCols (samples),
             {},
             0 };
}

PlayedRecording recordingOf (const FollowRequest& request, const ModalModel& model)
{
    const auto sensors = sensorCount (request, model);
    const auto given = request.voltages.has_value() + request.signals.has_value() + request.sampleRate.has_value();

    if (request.recorded.empty() ? given != 3 : given != 0)
        throw InputError (
            "recorded",
            "is not given alone; allowed: a folder, or from Python voltages_V with signals and sample_rate_Hz");

    return request.recorded.empty() ? givenRecording (request, model, sensors)
                                    : readPlayedRecording (request.recorded, model, sensors, request.sensor);
}
} // namespace

std::vector<Field> fields (FollowRequest& request)
{
    constexpr double percent = 100, milliseconds = 1000;
    const auto share = [&] (const char* option, double& value, double most, const char* text)
    { return Field (option, &value, text).in (percent).within (0, most); };
    std::vector<Field> all {
        Field ("device", &request.device, "Device before the drift: an embedded name or a .json file")
            .required()
            .positional(),
        Field ("--recorded", &request.recorded,
               "Folder with voltages.wav and with recorded.csv or recorded.wav of the sensors")
            .written ("FOLDER")
            .positional(),
        Field ("", &request.voltages, "Played voltages, instead of a folder: N_b x N_s, V").as ("voltages_V"),
        Field ("", &request.signals,
               "Recorded signals: N x N_s, velocities at the sensors, m/s, then the current of the idle ceramic")
            .as ("signals"),
        Field ("", &request.sampleRate, "Of both, Hz").as ("sample_rate_Hz").within (8000, 2e6),
        Field ("--sensors", &request.places, "Places of the velocity sensors").as ("sensors_mm").written ("POINTS.csv"),
        Field ("--idle-ceramic", &request.idleCeramic,
               "Ceramic that is not driven and whose current is the last channel, counted from 1; 0: none")
            .within (0, 4096),
        Field ("--latency-ms", &request.latency, "Latency of the recording, ms").in (milliseconds).within (0, 200),
        Field ("--snr-db", &request.signalToNoise, "Signal-to-noise ratio of the sensors, dB")
            .as ("snr_dB")
            .within (-20, 300),
        share ("--drift-percent", request.drift, 10, "Standard deviation of the drift common to all frequencies, %"),
        share ("--scatter-percent", request.scatter, 10,
               "Standard deviation of the individual drift of each frequency, %"),
        share ("--damping-percent", request.damping, 50, "Standard deviation of each damping ratio, %"),
        share ("--gain-percent", request.gain, 50, "Standard deviation of the gain of a sensor for each mode, %"),
        share ("--jump-percent", request.largestJump, 10, "Largest jump of all frequencies that is searched for, %"),
        Field ("--feedthrough", &request.feedthrough,
               "Standard deviation of the feedthrough of each voltage's slope to the sensors, in their unit per V/s")
            .within (0, 1)
            .by ("that of modes above those of the model"),
        Field ("--window-s", &request.window, "Length of a window, s").within (0, 60),
        Field ("--memory-s", &request.memory, "Memory of the slowest mode before each window, s").within (0, 10),
        cacheField (request.usesCache),
    };
    append (all, fields (request.sensor));
    return all;
}

FollowedDevice follow (const FollowRequest& request, const ShowProgress& progress)
{
    const auto show = [&] (const char* what, double share)
    {
        if (progress)
            progress (what, share);
    };
    show ("Modes of the device", 0);
    const auto known = solveDevice (request.device, {}, request.usesCache);
    checkKindOfPlaces (known, request.places, "sensor");
    auto recording = recordingOf (request, known);
    const auto wide = widened (request.device, known, recording.sampleRate, request.usesCache);
    auto nominal = modesWithin (wide.model, recording.sampleRate);
    const auto sensors = sensorsOf (request, nominal);
    recording.noise = noiseOfRecording (recording.signals, request.signalToNoise);
    recording.delay = request.latency;

    // A ceramic that listens is not driven, whatever its channel says.
    if (request.idleCeramic > 0)
        recording.voltages.row (request.idleCeramic - 1).setZero();

    auto trace = followRecording (nominal, sensors, recording, settingsOf (request, nominal, sensors), request.window,
                                  [&] (double share) { show ("Following", share); });
    const auto own = std::min (known.modes(), nominal.modes());
    return { request.device, std::move (nominal), own, std::move (trace) };
}

namespace
{
constexpr double inPpm = 1e6, inPercents = 100;
constexpr Eigen::Index mostCurves = 6; // of single modes in the picture

/** A line per moment: what all modes share, then each mode's change and its deviation. */
std::string driftTable (const DriftTrace& trace, Eigen::Index modes)
{
    constexpr int digits = 9;
    std::string text = "time_s,state,unexplained_percent,jump_percent,common_ppm";

    for (Eigen::Index k = 1; k <= modes; ++k)
        text += ",mode_" + std::to_string (k) + "_ppm,mode_" + std::to_string (k) + "_deviation_ppm";

    text += "\n";
    const auto add = [&] (double value)
    {
        text += ',';
        appendCsvNumber (text, value, digits);
    };

    for (const auto& moment : trace.moments)
    {
        appendCsvNumber (text, moment.time, digits);
        text += std::string (",") + driftStateWord (moment.state);
        add (inPercents * moment.unexplained);
        add (inPercents * moment.jump);
        add (inPpm * moment.common);

        for (Eigen::Index k = 0; k < modes; ++k)
        {
            add (inPpm * moment.frequencies[k]);
            add (inPpm * moment.deviations[k]);
        }

        text += "\n";
    }

    return text;
}

/** How one of the numbers of moments changes; gaps where nothing was heard. */
template <typename Value>
Series curve (const DriftTrace& trace, const std::string& name, const Value& value)
{
    const auto count = static_cast<Eigen::Index> (trace.moments.size());
    Series series;
    series.name = name;
    series.x.resize (count);
    series.y.resize (count);
    series.points = count < 100;

    for (Eigen::Index i = 0; i < count; ++i)
    {
        const auto& moment = trace.moments[static_cast<std::size_t> (i)];
        series.x[i] = moment.time;
        series.y[i] =
            moment.state == DriftState::following ? inPpm * value (moment) : std::numeric_limits<double>::quiet_NaN();
    }

    return series;
}

LineChart driftChart (const ModalModel& nominal, Eigen::Index known, const DriftTrace& trace)
{
    LineChart chart;
    chart.xLabel = "time (s)";
    chart.yLabel = "change of frequency (ppm)";
    chart.series.push_back (curve (trace, "common", [] (const DriftMoment& moment) { return moment.common; }));

    // The modes that are known best, from the lowest up.
    std::vector<Eigen::Index> modes (static_cast<std::size_t> (known));
    std::iota (modes.begin(), modes.end(), Eigen::Index { 0 });
    const auto& deviations = trace.moments.back().deviations;
    std::stable_sort (modes.begin(), modes.end(),
                      [&] (Eigen::Index a, Eigen::Index b) { return deviations[a] < deviations[b]; });
    modes.resize (std::min (modes.size(), static_cast<std::size_t> (mostCurves)));
    std::sort (modes.begin(), modes.end());

    for (const auto k : modes)
    {
        auto series = curve (trace, inWords (nominal.frequencyHz (k)) + " Hz",
                             [k] (const DriftMoment& moment) { return moment.frequencies[k]; });
        series.style = LineStyle::dashed;
        chart.series.push_back (std::move (series));
    }

    return chart;
}
} // namespace

const char* driftStateWord (DriftState state)
{
    return state == DriftState::following ? "following" : state == DriftState::silent ? "silent" : "lost";
}

ReportPage driftReport (const FollowedDevice& followed)
{
    const auto& [device, nominal, known, trace] = followed;
    ReportSection section;
    section.heading = "Frequencies";
    section.figures.push_back ({ "Change of all frequencies, and of the best observed modes, from the device. Gaps: "
                                 "nothing was played, or the signals were not explained.",
                                 {},
                                 driftChart (nominal, known, trace) });
    ReportTable table { "Windows that were not followed, and jumps",
                        { "time (s)", "state", "unexplained (%)", "jump (%)", "" },
                        {} };

    for (const auto& moment : trace.moments)
        if (moment.state == DriftState::lost || moment.jump != 0)
            table.rows.push_back ({ inWords (moment.time), driftStateWord (moment.state),
                                    inWords (inPercents * moment.unexplained), inWords (inPercents * moment.jump),
                                    moment.reason });

    if (! table.rows.empty())
        section.tables.push_back (std::move (table));

    ReportPage page;
    page.title = "Drift of " + nominal.name;
    page.sections = { std::move (section) };
    page.links = { { "drift.csv", "drift.csv" }, { "device.json", "device.json" } };
    page.footer = "Antinode " ANTINODE_VERSION ".";
    return page;
}

nlohmann::ordered_json driftToJson (const DriftTrace& trace)
{
    const auto count = [&] (DriftState state)
    {
        return std::count_if (trace.moments.begin(), trace.moments.end(),
                              [state] (const DriftMoment& moment) { return moment.state == state; });
    };
    const auto& last = trace.moments.back();
    return { { "schema", "antinode.drift/1" },
             { "windows_followed", count (DriftState::following) },
             { "windows_silent", count (DriftState::silent) },
             { "windows_lost", count (DriftState::lost) },
             { "common_ppm", inPpm * last.common },
             { "last_state", driftStateWord (last.state) },
             { "last_reason", last.reason } };
}

std::string driftedDeviceText (const FollowedDevice& followed)
{
    const auto& [device, nominal, known, trace] = followed;
    const auto drifted = driftedModel (nominal, driftLayout (nominal, 1), trace.estimate.values);
    return changedDeviceText (device, firstModes (nominal, known), firstModes (drifted, known),
                              "Followed while it was played");
}

void writeDrift (const std::filesystem::path& path, const FollowedDevice& followed)
{
    OutputFolder folder (path);
    folder.write ("drift.csv", driftTable (followed.trace, followed.known));
    folder.write ("device.json", driftedDeviceText (followed));
    folder.write ("summary.json", driftToJson (followed.trace).dump (2) + "\n");
    folder.write ("report.html", renderReport (driftReport (followed)));
    folder.commit();
}
} // namespace antinode
