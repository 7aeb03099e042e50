#include "CalibrationCommands.h"

#include "CommandLine.h"
#include "TaskCommand.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/Library.h>
#include <antinode_documents/MeasuredDevice.h>
#include <antinode_numerics/Statistics.h>
#include <antinode_reports/Report.h>
#include <antinode_tasks/BenchFields.h>
#include <antinode_tasks/Excite.h>
#include <antinode_tasks/Retune.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
constexpr double calibratedPercent = 100;

/** Hz; infinite without a low-pass. */
double bandwidthOf (const Amplifier& amplifier)
{
    return 1 / (2 * std::numbers::pi * amplifier.timeConstant);
}

std::vector<Amplifier> amplifiersOf (const AmplifierMeasurement& measurement)
{
    std::vector<Amplifier> amplifiers;

    for (const auto& measured : measurement.amplifiers)
        amplifiers.push_back (measured.amplifier);

    return amplifiers;
}

/** By how much the amplifiers differ in their lateness at the highest line, s. */
double latenessRange (const AmplifierMeasurement& measurement)
{
    const auto highest = measurement.frequencies[measurement.frequencies.size() - 1];
    double least = 1, most = -1;

    for (const auto& amplifier : amplifiersOf (measurement))
    {
        least = std::min (least, lateness (amplifier, highest));
        most = std::max (most, lateness (amplifier, highest));
    }

    return most - least;
}

nlohmann::ordered_json calibrationToJson (const ModalModel& model, const AmplifierMeasurement& measurement)
{
    nlohmann::ordered_json document { { "schema", "antinode.calibration/1" },
                                      { "device", model.name },
                                      { "lateness_range_us", latenessRange (measurement) * micro },
                                      { "amplifiers", nlohmann::ordered_json::array() } };

    for (std::size_t i = 0; i < measurement.amplifiers.size(); ++i)
    {
        const auto& [amplifier, misfit] = measurement.amplifiers[i];
        const auto bandwidth = bandwidthOf (amplifier);
        document["amplifiers"].push_back (
            { { "ceramic", model.ceramics[i].name },
              { "gain", amplifier.gain },
              { "bandwidth_Hz",
                std::isfinite (bandwidth) ? nlohmann::ordered_json (bandwidth) : nlohmann::ordered_json (nullptr) },
              { "delay_us", amplifier.delay * micro },
              { "misfit_percent", calibratedPercent * misfit } });
    }

    return document;
}

/** Gains over frequency, dB. */
LineChart gainChart (const ModalModel& model, const AmplifierMeasurement& measurement)
{
    constexpr double perDecade = 20;
    LineChart chart;
    chart.xLabel = "frequency (Hz)";
    chart.yLabel = "gain (dB)";

    for (std::size_t i = 0; i < measurement.amplifiers.size(); ++i)
    {
        const auto column = static_cast<Eigen::Index> (i);
        Series series { model.ceramics[i].name, measurement.frequencies,
                        perDecade * measurement.responses.col (column).cwiseAbs().array().log10() };
        chart.series.push_back (std::move (series));
    }

    chart.legend = chart.series.size() > 8 ? LegendPlace::none : LegendPlace::top;
    return chart;
}

ReportPage calibrationReport (const ModalModel& model, const AmplifierMeasurement& measurement)
{
    ReportSection section;
    section.heading = "Amplifiers";
    section.paragraphs = {
        "Designs for device.json compensate for the gains, within the limits of the ceramics. Its ceramics keep "
        "low-pass and delay as their lag: filters before the outputs compensate for it with a small delay. Not "
        "included: hysteresis of the ceramics, which monitors of amplifiers do not show; see antinode hysteresis."
    };
    section.figures.push_back (
        { "Voltage at the ceramic over the requested voltage.", {}, gainChart (model, measurement) });
    ReportTable table { "Each amplifier",
                        { "ceramic", "gain", "bandwidth (kHz)", "delay (us)", "late at the highest line (us)",
                          "not fitted (%)" },
                        {} };
    const auto highest = measurement.frequencies[measurement.frequencies.size() - 1];

    for (std::size_t i = 0; i < measurement.amplifiers.size(); ++i)
    {
        const auto& [amplifier, misfit] = measurement.amplifiers[i];
        table.rows.push_back ({ model.ceramics[i].name, fixedText (amplifier.gain, 4),
                                inWords (bandwidthOf (amplifier) / milli), fixedText (amplifier.delay * micro, 2),
                                fixedText (lateness (amplifier, highest) * micro, 2),
                                fixedText (calibratedPercent * misfit, 3) });
    }

    section.tables = { std::move (table) };
    ReportPage page;
    page.title = "Amplifiers of " + model.name;
    page.scores = { { "Differ in time by", fixedText (latenessRange (measurement) * micro, 2) + " us",
                      "At the highest line; compensated before the outputs." } };
    page.sections = { std::move (section) };
    page.links = { { "calibration.json", "calibration.json" }, { "device.json", "device.json" } };
    page.footer = "Antinode " ANTINODE_VERSION ".";
    return page;
}
} // namespace

void writeCalibration (const std::filesystem::path& path, const DeviceDescription& device, const ModalModel& model,
                       const AmplifierMeasurement& measurement)
{
    const auto calibrated = throughAmplifiers (model, amplifiersOf (measurement));
    OutputFolder folder (path);
    folder.write ("device.json", changedDeviceText (device, model, calibrated, "With its measured amplifiers"));
    folder.write ("calibration.json", calibrationToJson (model, measurement).dump (2) + "\n");
    folder.write ("report.html", renderReport (calibrationReport (model, measurement)));
    folder.commit();
}

void printCalibration (const std::string& folder, const ModalModel& model, const AmplifierMeasurement& measurement)
{
    std::printf ("%s\n  %-12s %10s %16s %12s %14s\n", model.name.c_str(), "ceramic", "gain", "bandwidth (kHz)",
                 "delay (us)", "not fitted (%)");

    for (std::size_t i = 0; i < measurement.amplifiers.size(); ++i)
    {
        const auto& [amplifier, misfit] = measurement.amplifiers[i];
        std::printf ("  %-12s %10.4f %16.2f %12.2f %14.3f\n", model.ceramics[i].name.c_str(), amplifier.gain,
                     bandwidthOf (amplifier) / milli, amplifier.delay * micro, calibratedPercent * misfit);
    }

    std::printf ("The device with its amplifiers: %s/device.json; report: %s/report.html\n", folder.c_str(),
                 folder.c_str());
}

namespace
{
constexpr double percent = 100, degrees = 180 / std::numbers::pi;

void requireSame (const FrequencyResponses& low, const FrequencyResponses& high, const ModalModel& model)
{
    if (std::ssize (low.references) != model.actuators() || low.references.size() != high.references.size())
        throw InputError ("--high", "needs, as --low, responses to each of the " + std::to_string (model.actuators())
                                        + " ceramics of the device");

    if (low.points.rows() != high.points.rows() || ! low.points.isApprox (high.points))
        throw InputError ("--high", "has other points than --low; allowed: the same points in the same order");

    if (low.frequencies.size() != high.frequencies.size() || ! low.frequencies.isApprox (high.frequencies))
        throw InputError ("--high", "has other lines than --low; allowed: the same excitation at another level");
}

/** The values that both have, in one order. */
std::pair<Eigen::VectorXcd, Eigen::VectorXcd> inBoth (const Eigen::MatrixXcd& low, const Eigen::MatrixXcd& high)
{
    std::vector<Eigen::Index> there;

    for (Eigen::Index n = 0; n < low.size(); ++n)
        if (std::isfinite (std::abs (low.reshaped()[n])) && std::isfinite (std::abs (high.reshaped()[n])))
            there.push_back (n);

    return { low.reshaped() (there), high.reshaped() (there) };
}
} // namespace

HysteresisMeasurement hysteresisByFiles (const DeviceDescription& device, const HysteresisFiles& files, bool usesCache)
{
    HysteresisMeasurement measurement { device, solveDevice (device, {}, usesCache), {}, {}, {} };
    const auto& model = measurement.before;
    const auto low = responsesOfFiles (files.low).responses, high = responsesOfFiles (files.high).responses;
    requireSame (low, high, model);
    std::vector<Hysteresis> all;
    measurement.playedLevels.resize (model.actuators());

    for (std::size_t i = 0; i < low.references.size(); ++i)
    {
        const auto& ceramic = model.ceramics[i];
        const auto limit = ceramic.voltageLimit;

        if (files.playedLevel > limit)
            throw InputError ("--played-level-v", "is " + inWords (files.playedLevel)
                                                      + " V; allowed: up to the limit of '" + ceramic.name + "', "
                                                      + inWords (limit) + " V");

        const auto [lowValues, highValues] = inBoth (low.values[i], high.values[i]);
        measurement.ceramics.push_back (
            fitHysteresis (highValues, lowValues, files.highLevel / limit, files.lowLevel / limit));
        measurement.playedLevels[static_cast<Eigen::Index> (i)] = files.playedLevel / limit;
        all.push_back (measurement.ceramics.back().hysteresis);
    }

    measurement.model = withHysteresis (model, all, measurement.playedLevels);
    return measurement;
}

void writeHysteresis (const std::filesystem::path& path, const HysteresisMeasurement& measurement)
{
    nlohmann::ordered_json document { { "schema", "antinode.hysteresis/1" },
                                      { "device", measurement.model.name },
                                      { "ceramics", nlohmann::ordered_json::array() } };

    for (std::size_t i = 0; i < measurement.ceramics.size(); ++i)
    {
        const auto& [hysteresis, misfit] = measurement.ceramics[i];
        document["ceramics"].push_back (
            { { "ceramic", measurement.model.ceramics[i].name },
              { "gain_at_full_level_percent", percent * hysteresis.gain },
              { "lag_at_full_level_deg", degrees * hysteresis.phase },
              { "played_level_percent", percent * measurement.playedLevels[static_cast<Eigen::Index> (i)] },
              { "misfit_percent", percent * misfit } });
    }

    OutputFolder folder (path);
    folder.write ("device.json", changedDeviceText (measurement.device, measurement.before, measurement.model,
                                                    "With gain and lag of its ceramics at the played level"));
    folder.write ("hysteresis.json", document.dump (2) + "\n");
    folder.commit();
}

void printHysteresis (const std::string& folder, const HysteresisMeasurement& measurement)
{
    std::printf ("%s\n  %-12s %20s %18s %18s %14s\n", measurement.model.name.c_str(), "ceramic", "full level adds (%)",
                 "and lags (deg)", "played level (%)", "not fitted (%)");

    for (std::size_t i = 0; i < measurement.ceramics.size(); ++i)
    {
        const auto& [hysteresis, misfit] = measurement.ceramics[i];
        std::printf ("  %-12s %20.3f %18.3f %18.1f %14.3f\n", measurement.model.ceramics[i].name.c_str(),
                     percent * hysteresis.gain, degrees * hysteresis.phase,
                     percent * measurement.playedLevels[static_cast<Eigen::Index> (i)], percent * misfit);
    }

    std::printf ("The device at the played level: %s/device.json; numbers: %s/hysteresis.json\n", folder.c_str(),
                 folder.c_str());
}

namespace
{
struct CalibrateOptions
{
    ExcitationRequest excitation;
    BenchWiring wiring;
    double monitor = 1, latency = 0; // V of a ceramic per V at the monitor's input; s
    std::string folder = "antinode-calibrated";
    bool isSimulated = false, asksNoQuestions = false;
    double simulatedGain = 5, simulatedBandwidth = 30, simulatedDelay = 10; // %, kHz, us
};

/** Amplifiers that differ: gains by a standard deviation, bandwidths and delays by a tenth. */
std::unique_ptr<Bench> simulatedAmplifiers (const CalibrateOptions& options, Eigen::Index ceramics)
{
    constexpr double scatter = 0.1, noise = 1e-3, latency = 1.234567e-3, kilo = 1000, micro = 1e6;
    RandomNumbers random (static_cast<std::uint64_t> (options.excitation.seed));
    std::vector<Amplifier> amplifiers;

    for (Eigen::Index i = 0; i < ceramics; ++i)
    {
        const auto deviations = random.normal (3);
        amplifiers.push_back (
            { 1 + options.simulatedGain / 100 * deviations[0],
              (1 + scatter * deviations[1]) / (2 * std::numbers::pi * kilo * options.simulatedBandwidth),
              (1 + scatter * deviations[2]) * options.simulatedDelay / micro });
    }

    return std::make_unique<SimulatedAmplifiers> (std::move (amplifiers), noise, latency, 1);
}

std::unique_ptr<Bench> monitoredBench (const CalibrateOptions& options, const ModalModel& model)
{
    constexpr double perMetre = 1000; // mm/s of a sensor: of a monitor volts take the place of m/s
    auto wiring = options.wiring;
    wiring.sensor.sensitivity = perMetre * options.monitor;
    return openAudioBench (wiring, model, options.excitation.sampleRate);
}

/** Waits until the user has moved the one monitor cable. */
void askForMonitor (const std::string& ceramic)
{
    std::printf ("Connect the monitor of the amplifier of '%s', then press Enter: ", ceramic.c_str());
    std::fflush (stdout);

    if (std::string answer; ! std::getline (std::cin, answer))
        throw InputError ("calibrate", "has ended before all amplifiers were measured");
}

void calibrate (const CalibrateOptions& options)
{
    const auto model = excitedModel (options.excitation.device, options.excitation.usesCache);
    const auto sheet = excitationFor (model, options.excitation);
    const auto bench =
        options.isSimulated ? simulatedAmplifiers (options, model.actuators()) : monitoredBench (options, model);
    const auto asks = ! options.isSimulated && ! options.asksNoQuestions && bench->sensors() == 1;
    const auto measurement =
        measureAmplifiers (*bench, sheet.excitation, options.latency * options.excitation.sampleRate,
                           [&] (Eigen::Index ceramic)
                           {
                               if (asks)
                                   askForMonitor (sheet.ceramics[static_cast<std::size_t> (ceramic)]);
                           });
    writeCalibration (options.folder, options.excitation.device, model, measurement);
    printCalibration (options.folder, model, measurement);
}
} // namespace

void addCalibrateCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (
        "calibrate", "Measures the amplifiers of a bench by their monitors: gain, bandwidth and delay of each");
    auto options = std::make_shared<CalibrateOptions>();
    constexpr double milliseconds = 1000;
    const std::string simulate = "--simulate";
    auto all = fields (options->excitation);
    append (all, fields (options->wiring));
    append (
        all,
        { fields (options->wiring.sensor).back(),
          Field ("--monitor-v-per-v", &options->monitor,
                 "Volts at a ceramic per volt of its amplifier's monitor output")
              .within (1e-6, 1e6),
          Field ("--latency-ms", &options->latency, "Latency of the monitors without a sync input, ms")
              .in (milliseconds)
              .within (0, 200),
          Field ("--no-questions", &options->asksNoQuestions, "Measures all amplifiers without asking"),
          Field (simulate, &options->isSimulated, "Measures simulated amplifiers"),
          Field ("--simulated-gain-percent", &options->simulatedGain, "Standard deviation of their gains, %")
              .within (0, 20)
              .with (simulate),
          Field ("--simulated-bandwidth-khz", &options->simulatedBandwidth, "Their bandwidth, kHz")
              .within (1, 1000)
              .with (simulate),
          Field ("--simulated-delay-us", &options->simulatedDelay, "Their delay, us").within (0, 10000).with (simulate),
          Field ("--out", &options->folder, "Output folder") });
    command->callback (
        [options, read = addFields (*command, all)]
        {
            read();
            calibrate (*options);
        });
}

namespace
{
struct HysteresisOptions
{
    DeviceDescription device;
    std::filesystem::path folder = "antinode-hysteresis";
    HysteresisFiles measured;
    bool usesCache = true;
};

Field levelField (const char* option, double& level, const char* what)
{
    return Field (option, &level, what).required().within (1e-6, 1e6);
}
} // namespace

void addHysteresisCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (
        "hysteresis",
        "Measures gain and lag of ceramics at high voltages by responses at two levels; writes the device there");
    auto options = std::make_shared<HysteresisOptions>();
    auto& measured = options->measured;
    const auto read = addFields (
        *command,
        { Field ("device", &options->device, "Device: an embedded name or a .json file").required(),
          Field ("--low", &measured.low,
                 "Frequency responses at a low level, as written by frf and measure (repeatable)")
              .required()
              .written ("FILE"),
          Field ("--high", &measured.high, "The same lines and points at a high level (repeatable)")
              .required()
              .written ("FILE"),
          levelField ("--low-level-v", measured.lowLevel, "Peak voltage of the low level, V"),
          levelField ("--high-level-v", measured.highLevel, "Peak voltage of the high level, V"),
          levelField ("--played-level-v", measured.playedLevel, "Peak voltage of the foci for device.json, V"),
          Field ("--out", &options->folder, "Output folder"), cacheField (options->usesCache) });
    command->callback (
        [options, read]
        {
            read();
            const auto measurement = hysteresisByFiles (options->device, options->measured, options->usesCache);
            writeHysteresis (options->folder, measurement);
            printHysteresis (options->folder.string(), measurement);
        });
}
} // namespace antinode
