#include "Commands.h"
#include "FieldOptions.h"

#include <antinode_bench/Checklist.h>
#include <antinode_reports/MeasurementReport.h>
#include <antinode_tasks/DeviceChecks.h>
#include <antinode_tasks/Measure.h>
#include <antinode_text/OutputFolder.h>

#include <cstdio>
#include <memory>

namespace antinode
{
namespace
{
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

    const auto measured = measureOnBench (options.request, PointGuide (options.isSimulated || options.asksNoQuestions));
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
