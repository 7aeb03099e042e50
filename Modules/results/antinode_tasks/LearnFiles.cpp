#include "LearnFiles.h"

#include "LearnReport.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/WholeFile.h>
#include <antinode_documents/ChangedDevice.h>
#include <antinode_documents/DesignFile.h>
#include <antinode_learning/EquivalentLinear.h>
#include <antinode_learning/LearningVerdict.h>
#include <antinode_render/LagOutcome.h>
#include <antinode_text/CsvTable.h>
#include <antinode_text/OutputFolder.h>
#include <antinode_text/WaveFile.h>
#include <antinode_text/WaveReader.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace antinode
{
namespace
{
constexpr double inPercent = 100, inMilli = 1000;

/** Velocities of a table's columns but the time: sensors x N_s, m/s. */
Eigen::MatrixXd recordedTable (const std::filesystem::path& path)
{
    const auto table = readCsvTable (readWholeFile (path, { "a CSV file" }), path.string());

    for (std::size_t i = 1; i < table.headings.size(); ++i)
        if (table.headings[i].find ("_mm_s") == std::string::npos)
            throw InputError (path.string(), "has the heading '" + table.headings[i]
                                                 + "'; allowed: time_s, then velocity_mm_s_1 and so on");

    return table.numbers.rightCols (table.numbers.cols() - 1).transpose() / milli;
}

/** A table of modes: as they were taken, as they are now, and the deviations before and after. */
std::string learntTable (const LearntFocus& learnt, const WideModel& nominal, const ModeSpread& before)
{
    std::string text = "mode,frequency_Hz_before,frequency_Hz_now,frequency_deviation_percent_before,"
                       "frequency_deviation_percent_now,damping_ratio_before,damping_ratio_now,"
                       "damping_deviation_percent_before,damping_deviation_percent_now,"
                       "participation_deviation_percent_before,participation_deviation_percent_now\n";
    const auto& now = learnt.learnt;

    for (Eigen::Index k = 0; k < nominal.known; ++k)
    {
        std::array<char, 320> line {};
        std::snprintf (line.data(), line.size(), "%td,%.9g,%.9g,%.4g,%.4g,%.9g,%.9g,%.4g,%.4g,%.4g,%.4g\n", k + 1,
                       nominal.model.frequencyHz (k), now.model.frequencyHz (k), inPercent * before.frequencies[k],
                       inPercent * now.frequencyDeviations[k], nominal.model.dampingRatios[k],
                       now.model.dampingRatios[k], inPercent * before.dampings[k], inPercent * now.dampingDeviations[k],
                       inPercent * before.participation[k], inPercent * now.participationDeviations[k]);
        text += line.data();
    }

    return text;
}

/** What was learnt of each ceramic: at its largest voltage of the last play. */
nlohmann::ordered_json ceramicsToJson (const LearntFocus& learnt)
{
    auto ceramics = nlohmann::ordered_json::array();

    if (learnt.passes.empty())
        return ceramics;

    const auto& voltages = learnt.passes.back().voltages;
    const auto shares = distortionShares (learnt.learnt.distortions, voltages);
    const auto deviations = distortionShares (learnt.learnt.distortionDeviations, voltages);

    for (Eigen::Index i = 0; i < shares.size(); ++i)
        ceramics.push_back ({ { "name", learnt.learnt.model.ceramics[static_cast<std::size_t> (i)].name },
                              { "distortion_percent", inPercent * shares[i] },
                              { "distortion_deviation_percent", inPercent * deviations[i] } });

    return ceramics;
}
} // namespace

PlayedRecording readPlayedRecording (const std::filesystem::path& folder, const ModalModel& model, Eigen::Index sensors,
                                     const SensorScale& sensor)
{
    const auto wave = readWaveFile (folder / "voltages.wav");

    if (wave.samples.rows() != model.actuators())
        throw InputError ((folder / "voltages.wav").string(),
                          "has " + std::to_string (wave.samples.rows()) + " channels; allowed: "
                              + std::to_string (model.actuators()) + ", one per ceramic of '" + model.name + "'");

    const auto file = recordedFile (folder);
    const auto signals =
        file.extension() == ".csv" ? recordedTable (file) : recordedVelocities (file, wave.sampleRate, sensor);

    if (signals.rows() != sensors)
        throw InputError (file.string(), "has " + std::to_string (signals.rows())
                                             + " channels; allowed: " + std::to_string (sensors) + ", one per sensor");

    const auto samples = std::min (wave.samples.cols(), signals.cols());
    return { wave.sampleRate,
             withLags (model, model.fullScaleVoltage * wave.samples, wave.sampleRate).leftCols (samples),
             signals.leftCols (samples),
             {},
             0 };
}

Eigen::VectorXd noiseOfRecording (const Eigen::MatrixXd& signals, double signalToNoise)
{
    return std::pow (10.0, -signalToNoise / 20)
           * (signals.rowwise().norm() / std::sqrt (static_cast<double> (signals.cols()))).cwiseMax (1e-30);
}

UndoneLags learntOutputs (const LearntFocus& learnt, const LearningSettings& settings)
{
    const auto known = firstModes (learnt.wide.model, learnt.wide.known);
    return withLagsUndone (known, playedVoltages (known, learnt.design, settings), learnt.design.program.voltageLimits,
                           settings.sampleRate);
}

std::string keptInWords (const LearntFocus& learnt)
{
    return learnt.kept == 0 ? "Nothing is changed. "
                            : "What was played in pass " + std::to_string (learnt.kept + 1) + " is kept. ";
}

nlohmann::ordered_json learntToJson (const LearntFocus& learnt)
{
    nlohmann::ordered_json document { { "schema", "antinode.learnt/1" },
                                      { "is_accepted", learnt.refusal.empty() },
                                      { "refusal", learnt.refusal },
                                      { "warning", warningOf (learnt) },
                                      { "kept_play", learnt.kept + 1 },
                                      { "unexplained_percent", inPercent * learnt.learnt.unexplained },
                                      { "residual_of_noise", learnt.learnt.residual },
                                      { "held_back_percent", inPercent * learnt.learnt.heldBack },
                                      { "held_back_before_percent", inPercent * learnt.learnt.heldBackBefore },
                                      { "trigger_sample", 0 } };
    auto& passes = document["passes"] = nlohmann::ordered_json::array();

    for (const auto& pass : learnt.passes)
        passes.push_back ({ { "estimated_field_error_percent", inPercent * pass.estimatedError },
                            { "surprise_of_noise", pass.surprise },
                            { "surprise_of_noise_nominal", pass.nominalSurprise },
                            { "latency_ms", inMilli * pass.delay } });

    document["ceramics"] = ceramicsToJson (learnt);
    return document;
}

std::string learntDeviceText (const LearntDevice& device)
{
    const auto& [setup, settings, learnt] = device;
    const auto before = firstModes (setup.device, setup.nominal.known);
    auto now = firstModes (learnt.wide.model, learnt.wide.known);

    for (Eigen::Index i = 0; i < now.actuators(); ++i)
        if (setup.nominal.model.participation.col (i).isZero (0)) // They only listened.
            now.participation.col (i) = before.participation.col (i);

    if (now.origin.source == ModeSource::drawn && learnt.refusal.empty())
        now.origin = { ModeSource::retuned, static_cast<int> (setup.places.rows()), learnt.learnt.unexplained };

    return changedDeviceText (setup.described, before, now, "Learnt from plays of a focus");
}

void writeLearnt (const std::filesystem::path& path, const LearntDevice& device)
{
    const auto& [setup, settings, learnt] = device;
    const auto& nominal = setup.nominal;
    const auto& before = setup.deviations;
    const auto known = firstModes (learnt.wide.model, learnt.wide.known);
    const auto outputs = learntOutputs (learnt, settings);
    auto summary = learntToJson (learnt);

    if (needsLagFilters (known))
    {
        summary["trigger_sample"] = outputs.lateness;
        summary["lag"] = lagJson (outputs);
    }

    OutputFolder folder (path);
    folder.write ("voltages.wav", encodeWave (outputs.voltages, known.fullScaleVoltage, settings.sampleRate));
    folder.write ("design.json", designToJson (learnt.design, known).dump (2) + "\n");
    folder.write ("device.json", learntDeviceText (device));
    folder.write ("learnt.csv", learntTable (learnt, nominal, before));
    folder.write ("summary.json", summary.dump (2) + "\n");
    folder.write ("report.html", renderReport (learningReport (learnt, nominal, before)));
    folder.commit();
}
} // namespace antinode
