#include "CalibrationFiles.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/ChangedDevice.h>
#include <antinode_reports/Report.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

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
} // namespace antinode
