#include "CommandLine.h"
#include "TaskCommand.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_bench/AudioBench.h>
#include <antinode_reports/MeasurementReport.h>
#include <antinode_tasks/DeviceChecks.h>
#include <antinode_tasks/Excite.h>
#include <antinode_tasks/Frf.h>
#include <antinode_tasks/Measure.h>
#include <antinode_text/OutputFolder.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

namespace antinode
{
namespace
{
void print (const ExcitationSheet& sheet, const std::string& signal, const std::string& folder)
{
    const auto& excitation = sheet.excitation;
    const auto& settings = excitation.settings;
    std::printf (
        "%s: %td ceramics and a sync channel, %.1f s at %.0f Hz\n", sheet.device.c_str(), excitation.ceramics(),
        static_cast<double> (excitation.ceramics() * excitation.runLength) / settings.sampleRate, settings.sampleRate);
    std::printf ("  %s, %zu lines from %.6g to %.6g Hz, %.4g Hz apart\n", signal.c_str(), excitation.lines.size(),
                 excitation.lineFrequency (excitation.lines.front()),
                 excitation.lineFrequency (excitation.lines.back()),
                 settings.sampleRate / static_cast<double> (excitation.lineBlock));
    std::printf ("  crest factor %.2f, peak %.4g to %.4g V\n", excitation.crestFactor, settings.levels.minCoeff(),
                 settings.levels.maxCoeff());
    std::printf ("Play %s/excitation.wav, record, then run: antinode frf %s/excitation.json RECORDINGS\n",
                 folder.c_str(), folder.c_str());
}
} // namespace

void addExciteCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (exciteText.name, exciteText.summary);
    auto request = std::make_shared<ExcitationRequest>();
    auto folder = std::make_shared<std::filesystem::path>();
    auto options = fields (*request);
    options.push_back (
        Field ("--out", folder.get(), "Output folder for excitation.wav and its sheet").written ("DIR").required());
    command->callback (
        [request, folder, read = addFields (*command, options)]
        {
            read();
            const auto sheet = excite (*request, {});
            writeExcitation (*folder, sheet);
            print (sheet, request->signal, folder->string());
        });
}

namespace
{
void printHits (const HammerMeasurement& measurement)
{
    for (std::size_t i = 0; i < measurement.recordings.size(); ++i)
    {
        const auto& hits = measurement.test.hits[i];
        const auto& recording = measurement.recordings[i];
        std::size_t used = 0;

        for (const auto& hit : hits)
            used += hit.fault.empty() ? 1 : 0;

        std::printf ("%s: %zu of %zu hits used\n", recording.source.c_str(), used, hits.size());

        for (std::size_t h = 0; h < hits.size(); ++h)
            if (! hits[h].fault.empty())
                std::printf ("  hit %zu at %.3f s left out: %s\n", h + 1,
                             static_cast<double> (hits[h].trigger) / recording.sampleRate, hits[h].fault.c_str());
    }
}

/** Over all lines and responses that have one; not a number where none has. */
double meanCoherenceOf (const HammerMeasurement& measurement)
{
    double sum = 0;
    Eigen::Index count = 0;

    for (const auto& coherence : measurement.coherence)
        for (const auto value : coherence.reshaped())
            if (std::isfinite (value))
            {
                sum += value;
                ++count;
            }

    return sum / static_cast<double> (count);
}

void printOutcome (const HammerMeasurement& measurement)
{
    const auto& frequencies = measurement.responses.frequencies;
    const auto rate = measurement.recordings.front().sampleRate;
    const auto spacing = rate / static_cast<double> (measurement.test.block);
    const auto coherence = meanCoherenceOf (measurement);

    for (const auto& remark : measurement.remarks)
        std::printf ("%s\n", remark.c_str());

    constexpr double disturbing = 0.01;

    if (const auto before = measurement.test.motionBefore; before > disturbing)
        std::printf ("Warning: before a hit the signal has %.1f %% of the hit's motion: wait longer between hits, or "
                     "lower the noise\n",
                     100 * before);

    if (measurement.test.windowDecay > 0)
        std::printf ("Exponential window of %.4g 1/s: identify subtracts its damping\n", measurement.test.windowDecay);
    else
        std::printf ("No exponential window: the motion has decayed at the end of a hit\n");

    std::printf ("%s to %s Hz every %.4g Hz, responses of %td points and directions to %zu references, ",
                 inWords (frequencies[0]).c_str(), inWords (frequencies[frequencies.size() - 1]).c_str(), spacing,
                 measurement.responses.points.rows(), measurement.responses.references.size());
    std::printf ("%s\n", std::isfinite (coherence) ? formatted ("mean coherence %.4f", coherence).c_str()
                                                   : "no coherence: one hit each");
}

void refuse (const CLI::App& command, const std::vector<Field>& fields, const std::string& wrong)
{
    for (const auto& field : fields)
        if (command.get_option (field.option)->count() > 0)
            throw InputError (field.option, wrong);
}

/** Options of one kind of recording are not for the other. */
void refuseOtherKind (const CLI::App& command, FrfRequest& request)
{
    const auto kinds = fieldsByKind (request);

    if (isOfExcitation (request))
        refuse (command, kinds.ofHammer, "belongs to recordings of a hammer, which are given without a sheet");
    else
        refuse (command, kinds.ofExcitation,
                "belongs to an excitation, whose sheet excitation.json is then the first file");
}

void print (const RecordedResponses& estimated, const std::string& file)
{
    if (estimated.hammer)
    {
        printHits (*estimated.hammer);
        printOutcome (*estimated.hammer);
        std::printf ("Responses: %s\n", file.c_str());
        return;
    }

    printMeasurement (*estimated.surface, *estimated.sheet);

    if (! estimated.orderRemark.empty())
        std::printf ("%s\n", estimated.orderRemark.c_str());
}
} // namespace

void addFrfCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (frfText.name, frfText.summary);
    auto request = std::make_shared<FrfRequest>();
    auto file = std::make_shared<std::filesystem::path>(), reportFolder = std::make_shared<std::filesystem::path>();
    auto all = fields (*request);
    append (all,
            { Field ("--out", file.get(), "Universal file to write").written ("FILE").required(),
              Field ("--report", reportFolder.get(), "Writes a report with figures into a folder").written ("DIR") });
    command->callback (
        [command, request, file, reportFolder, read = addFields (*command, all)]
        {
            read();
            refuseOtherKind (*command, *request);
            const auto estimated = frf (*request, {});

            if (! reportFolder->empty())
            {
                OutputFolder folder (*reportFolder);
                folder.write ("report.html", renderReport (frfReport (estimated)));
                folder.commit();
            }

            writeWholeFile (*file, universalFile (estimated));
            print (estimated, file->string());
        });
}

namespace
{
/** Asks at a point until it understands; the end of the input means the end. */
PointAnswer askAtPoint (const Eigen::MatrixX2d& places, Eigen::Index first, Eigen::Index count)
{
    std::string answer;

    while (true)
    {
        for (auto p = first; p < first + count; ++p)
            std::printf ("point %td of %td: %.6g, %.6g mm\n", p + 1, places.rows(), places (p, 0) * milli,
                         places (p, 1) * milli);

        std::printf ("Enter measures, s skips, r repeats the previous point, q ends for now: ");
        std::fflush (stdout);

        if (! std::getline (std::cin, answer) || answer == "q")
            return PointAnswer::end;

        if (answer == "s")
            return PointAnswer::skip;

        if (answer == "r")
            return PointAnswer::again;

        if (answer.empty())
            return PointAnswer::measure;
    }
}

/** Leads a user with a scanning sensor by lines on the terminal. */
PointGuide terminalGuide (bool asksNoQuestions)
{
    PointGuide guide;
    guide.tell = [] (const std::string& sentence)
    {
        std::printf ("%s\n", sentence.c_str());
        std::fflush (stdout);
    };

    if (! asksNoQuestions)
        guide.ask = askAtPoint;

    return guide;
}

struct MeasureOptions
{
    MeasureRequest request;
    bool isSimulated = false, asksNoQuestions = false, onlyChecks = false;
};

void writeChecklist (const MeasureRequest& request)
{
    const auto model = excitedModel (request.excitation.device, request.excitation.usesCache);
    checkKindOfPlaces (model, request.points, "point");
    const auto text = benchChecklist (model, excitationFor (model, request.excitation), request.points,
                                      benchChannels (request.wiring, model.actuators()), request.wiring.sensor);
    OutputFolder output (request.folder);
    output.write ("checklist.txt", text);
    output.commit();
    std::printf ("%sIn %s/checklist.txt\n", text.c_str(), request.folder.c_str());
}

void runMeasure (MeasureOptions& options)
{
    options.request.isSimulated = options.isSimulated;

    if (options.onlyChecks)
        return writeChecklist (options.request);

    const auto measured =
        measureOnBench (options.request, terminalGuide (options.isSimulated || options.asksNoQuestions));
    printMeasurement (measured.measurement, measured.sheet);
    std::printf ("Responses and figures: %s/responses.uff, report.html\n", options.request.folder.c_str());
}
} // namespace

void addMeasureCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (measureText.name, measureText.summary);
    auto options = std::make_shared<MeasureOptions>();
    auto& request = options->request;
    std::vector<Field> all {
        Field ("--checklist", &options->onlyChecks,
               "Writes a checklist of connections and expected values for this device and these points; plays nothing"),
        Field ("--no-questions", &options->asksNoQuestions, "Measures all points without asking"),
        Field ("--simulate", &options->isSimulated,
               "Measures on a simulated bench with the device's modes, noise and delay"),
    };
    append (all, fields (request));
    append (all, fields (request.wiring));
    append (all, fields (request.wiring.sensor));
    append (all, { Field ("--latency-ms", &request.latency, "Latency of the sensors without a sync input, ms")
                       .in (1000)
                       .within (0, 200) });
    command->callback (
        [options, read = addFields (*command, all)]
        {
            read();
            runMeasure (*options);
        });
}
} // namespace antinode
