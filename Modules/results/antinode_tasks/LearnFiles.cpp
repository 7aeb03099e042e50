#include "LearnFiles.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/WholeFile.h>
#include <antinode_documents/DesignFile.h>
#include <antinode_documents/MeasuredDevice.h>
#include <antinode_learning/LearningPasses.h>
#include <antinode_learning/LearntDesign.h>
#include <antinode_render/FocusOutcome.h>
#include <antinode_text/CsvTable.h>
#include <antinode_text/OutputFolder.h>
#include <antinode_text/WaveFile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

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

namespace
{
constexpr double shownPercent = 100;
constexpr double untold = 0.7; // of the deviation before: where more is left the data said little

/** What is shown of one kind of parameter, by mode. */
struct LearntKind
{
    std::string name;                     ///< "frequency"
    Eigen::VectorXd changes, before, now; ///< Relative: changes, deviations before and now.
};

LearntKind frequenciesOf (const LearntFocus& learnt, const WideModel& nominal, const ModeSpread& before)
{
    const auto known = nominal.known;
    return { "frequency",
             learnt.learnt.model.angularFrequencies.head (known)
                     .cwiseQuotient (nominal.model.angularFrequencies.head (known))
                     .array()
                 - 1,
             before.frequencies.head (known), learnt.learnt.frequencyDeviations.head (known) };
}

LearntKind dampingsOf (const LearntFocus& learnt, const WideModel& nominal, const ModeSpread& before)
{
    const auto known = nominal.known;
    return {
        "damping ratio",
        learnt.learnt.model.dampingRatios.head (known).cwiseQuotient (nominal.model.dampingRatios.head (known)).array()
            - 1,
        before.dampings.head (known), learnt.learnt.dampingDeviations.head (known)
    };
}

/** Changes of one kind over frequency, within the deviations that are left and those before. */
LineChart changeChart (const LearntKind& kind, const WideModel& nominal)
{
    const Eigen::VectorXd frequencies = nominal.model.angularFrequencies.head (nominal.known) / (2 * std::numbers::pi);
    LineChart chart;
    chart.xLabel = "frequency of the mode (Hz)";
    chart.yLabel = "change of the " + kind.name + " (%)";
    Series changes { "learnt", frequencies, shownPercent * kind.changes };
    changes.points = true;
    chart.series = {
        changes,
        { "learnt + deviation left", frequencies, shownPercent * (kind.changes + kind.now), LineStyle::dotted },
        { "learnt - deviation left", frequencies, shownPercent * (kind.changes - kind.now), LineStyle::dotted }
    };
    chart.series[1].colour = chart.series[2].colour = series_colour::neutral;
    chart.limits = { { shownPercent * kind.before.maxCoeff(), "deviation before" },
                     { -shownPercent * kind.before.maxCoeff(), "deviation before" } };
    return chart;
}

ReportSection passSection (const LearntFocus& learnt)
{
    const auto count = std::ssize (learnt.passes);
    Series errors { "field error", Eigen::VectorXd::LinSpaced (count, 1, static_cast<double> (count)),
                    Eigen::VectorXd (count) };
    errors.points = true;
    ReportTable table { "Each play. Not predicted: RMS of the signals that the model of its design did not predict, "
                        "relative to the noise.",
                        { "play", "field error (%)", "not predicted", "not predicted by the previous device",
                          "latency (ms)" },
                        {} };

    for (Eigen::Index i = 0; i < count; ++i)
    {
        const auto& pass = learnt.passes[static_cast<std::size_t> (i)];
        errors.y[i] = shownPercent * pass.estimatedError;
        table.rows.push_back ({ std::to_string (i + 1), fixedText (shownPercent * pass.estimatedError, 3),
                                fixedText (pass.surprise, 1), fixedText (pass.nominalSurprise, 1),
                                fixedText (pass.delay * milli, 4) });
    }

    LineChart chart;
    chart.xLabel = "play";
    chart.yLabel = "field error (%)";
    chart.series = { errors };
    chart.legend = LegendPlace::none;
    chart.logarithmicY = count > 0 && errors.y.minCoeff() > 0;
    ReportSection section;
    section.heading = "From play to play";
    section.paragraphs = {
        "The field error at the focus is estimated with the device learnt from all plays: RMS over the surface, "
        "relative to the wanted field. A wrong model also gives a wrong estimate: verify it by a scan of the focus."
    };
    section.figures.push_back ({ "Field error of each play.", {}, std::move (chart) });
    section.tables.push_back (std::move (table));
    return section;
}

ReportSection modeSection (const LearntFocus& learnt, const WideModel& nominal, const ModeSpread& before)
{
    const auto frequencies = frequenciesOf (learnt, nominal, before), dampings = dampingsOf (learnt, nominal, before);
    ReportSection section;
    section.heading = "What was learnt";
    section.figures.push_back ({ "Change of each frequency. Dotted: by one remaining standard deviation.",
                                 {},
                                 changeChart (frequencies, nominal) });
    section.figures.push_back ({ "Change of each damping ratio.", {}, changeChart (dampings, nominal) });
    ReportTable table { "Modes of the device; deviations are standard deviations, before and now, %",
                        { "mode", "frequency (Hz)", "now (Hz)", "deviation", "now", "damping ratio", "now", "deviation",
                          "now", "participation: deviation", "now" },
                        {} };

    for (Eigen::Index k = 0; k < nominal.known; ++k)
        table.rows.push_back (
            { std::to_string (k + 1), fixedText (nominal.model.frequencyHz (k), 2),
              fixedText (learnt.learnt.model.frequencyHz (k), 2), fixedText (shownPercent * frequencies.before[k], 3),
              fixedText (shownPercent * frequencies.now[k], 4), fixedText (nominal.model.dampingRatios[k], 5),
              fixedText (learnt.learnt.model.dampingRatios[k], 5), fixedText (shownPercent * dampings.before[k], 1),
              fixedText (shownPercent * dampings.now[k], 2), fixedText (shownPercent * before.participation[k], 1),
              fixedText (shownPercent * learnt.learnt.participationDeviations[k], 2) });

    section.tables.push_back (std::move (table));
    return section;
}

ReportSection ceramicSection (const LearntFocus& learnt)
{
    const auto& voltages = learnt.passes.back().voltages;
    const auto distortions = distortionShares (learnt.learnt.distortions, voltages);
    const auto deviations = distortionShares (learnt.learnt.distortionDeviations, voltages);
    ReportSection section;
    section.heading = "Ceramics";
    section.paragraphs = {
        "A ceramic acts like a linear one under the voltage U + c U^3: above 0 it moves more than in proportion. "
        + std::string (learnt.refusal.empty()
                           ? "The design and device.json compensate for it at about the played level."
                           : "This is not used.")
    };
    ReportTable table { "Cubic distortion of each ceramic at its largest voltage of the last play",
                        { "ceramic", "largest voltage (V)", "distortion (%)", "deviation left (%)" },
                        {} };

    for (Eigen::Index i = 0; i < distortions.size(); ++i)
        table.rows.push_back ({ learnt.learnt.model.ceramics[static_cast<std::size_t> (i)].name,
                                fixedText (voltages.row (i).lpNorm<Eigen::Infinity>(), 1),
                                fixedText (shownPercent * distortions[i], 3),
                                fixedText (shownPercent * deviations[i], 3) });

    section.tables.push_back (std::move (table));
    return section;
}

/** The modes of which the data said little, as numbers from 1: "3, 5 and 12". */
std::string untoldModes (const Eigen::VectorXd& now, const Eigen::VectorXd& before, Eigen::Index known)
{
    std::vector<std::string> names;

    for (Eigen::Index k = 0; k < known; ++k)
        if (now[k] > untold * before[k])
            names.push_back (std::to_string (k + 1));

    std::string text;

    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];

    return text;
}

ReportSection untoldSection (const LearntFocus& learnt, const WideModel& nominal, const ModeSpread& before)
{
    ReportSection section;
    section.heading = "What the data did not determine";
    const auto add = [&] (const std::string& what, const Eigen::VectorXd& now, const Eigen::VectorXd& was)
    {
        const auto modes = untoldModes (now, was, nominal.known);
        section.paragraphs.push_back (modes.empty() ? "The sensors determine the " + what + " of every mode."
                                                    : "More than " + fixedText (shownPercent * untold, 0)
                                                          + " % of the deviation remains for the " + what + " of mode "
                                                          + modes + ".");
    };
    add ("frequency", learnt.learnt.frequencyDeviations, before.frequencies);
    add ("damping ratio", learnt.learnt.dampingDeviations, before.dampings);
    add ("participations", learnt.learnt.participationDeviations, before.participation);
    section.paragraphs.push_back (
        "A mode stays undetermined if the sensors are on its nodes or the focus does not play it; one focus shows only "
        "a few combinations of the participations of a mode. Modes that do not matter for this focus are not observed; "
        "another focus may need them.");
    return section;
}
} // namespace

ReportPage learningReport (const LearntFocus& learnt, const WideModel& nominal, const ModeSpread& before)
{
    ReportPage page;
    page.title = "Learnt from plays";
    page.subtitle = nominal.model.name + ", " + std::to_string (learnt.passes.size()) + " plays";

    if (! learnt.refusal.empty())
        page.warnings = { keptInWords (learnt) + learnt.refusal };
    else if (const auto warning = warningOf (learnt); ! warning.empty())
        page.warnings = { warning };

    if (! learnt.passes.empty())
    {
        page.scores = { { "First play", fixedText (shownPercent * learnt.passes.front().estimatedError, 2) + " %",
                          "Its estimated field error." },
                        { "Last play", fixedText (shownPercent * learnt.passes.back().estimatedError, 2) + " %",
                          "The same." },
                        { "Not explained", fixedText (shownPercent * learnt.learnt.unexplained, 2) + " %",
                          "Of the signals, RMS: noise, and the part that the model does not explain." } };
        page.sections = { passSection (learnt), modeSection (learnt, nominal, before) };

        if (learnt.learnt.distortionDeviations.maxCoeff() > 0)
            page.sections.push_back (ceramicSection (learnt));

        page.sections.push_back (untoldSection (learnt, nominal, before));
    }

    page.links = { { "learnt.csv", "learnt.csv" },
                   { "device.json", "device.json" },
                   { "summary.json", "summary.json" } };
    page.footer = "Antinode " ANTINODE_VERSION ".";
    return page;
}
} // namespace antinode
