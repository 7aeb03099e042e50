#include "Measure.h"

#include "DeviceChecks.h"

#include <antinode_base/InputError.h>
#include <antinode_bench/Bench.h>
#include <antinode_bench/Measuring.h>
#include <antinode_reports/MeasurementReport.h>
#include <antinode_responses/UniversalFile.h>
#include <antinode_responses/UniversalResponses.h>
#include <antinode_text/OutputFolder.h>

#include <algorithm>

namespace antinode
{
namespace
{
std::unique_ptr<Bench> benchFor (const MeasureRequest& request, const ModalModel& model)
{
    if (! request.isSimulated)
        return openAudioBench (request.wiring, model, request.excitation.sampleRate);

    return std::make_unique<SimulatedBenchPlayer> (
        request.simulatedDevice ? excitedModel (*request.simulatedDevice, request.excitation.usesCache) : model,
        request.points, request.simulation);
}
} // namespace

std::vector<Field> fields (MeasureRequest& request)
{
    constexpr double percent = 100, milliseconds = 1000;
    const std::string simulate = "--simulate";
    auto all = fields (request.excitation);
    append (all,
            { Field ("--points", &request.points, "Points that are measured")
                  .as ("points_mm")
                  .written ("FILE")
                  .required()
                  .positional(),
              Field ("--out", &request.folder, "Folder of the measurement; an interrupted measurement is resumed")
                  .as ("folder")
                  .written ("DIR")
                  .required()
                  .positional(),
              Field ("", &request.isSimulated,
                     "True: a bench with a sensor is measured by the command, which asks for it point by point")
                  .as ("simulate"),
              Field ("--simulated-device", OptionalDevice { &request.simulatedDevice }, "Device on the simulated bench")
                  .by ("the same device")
                  .with (simulate),
              Field ("--snr-db", &request.simulation.signalToNoise, "Signal-to-noise ratio of the simulated bench, dB")
                  .as ("snr_dB")
                  .within (-20, 300)
                  .with (simulate),
              Field ("--delay-ms", &request.simulation.delay, "Latency of the simulated bench, ms")
                  .in (milliseconds)
                  .within (0, 200)
                  .with (simulate),
              Field ("--cubic-percent", &request.simulation.cubic,
                     "Cubic distortion of the simulated bench at full level, %")
                  .in (percent)
                  .within (-20, 20)
                  .with (simulate) });
    return all;
}

MeasuredSurface measureOnBench (const MeasureRequest& request, const PointGuide& guide, const OpenBench& open)
{
    const auto model = excitedModel (request.excitation.device, request.excitation.usesCache);
    checkKindOfPlaces (model, request.points, "point");
    auto sheet = excitationFor (model, request.excitation);
    const auto bench = open ? open (model, request.points) : benchFor (request, model);
    const MeasurementFolder folder (request.folder, sheet, request.points);
    RunAnalysisSettings analysis;
    analysis.latency = request.latency * request.excitation.sampleRate;
    auto measurement = measurePoints (*bench, sheet, request.points, folder, guide, analysis, model);
    OutputFolder output (request.folder);
    output.write ("responses.uff", encodeUniversalFile (responseSets (measurement.responses)));
    output.write ("report.html", renderReport (measurementReport (measurement, sheet)));
    output.commit();
    return { std::move (measurement), std::move (sheet) };
}

MeasuredSurface measure (const MeasureRequest& request, const ShowProgress& show)
{
    if (! request.isSimulated)
        throw InputError ("simulate", "is False; allowed: True, or a bench with a sensor by `antinode measure`");

    double told = 0;
    PointGuide guide;
    guide.tell = [&] (const std::string& sentence)
    {
        if (show)
            show (sentence, std::min (1.0, told++ / static_cast<double> (request.points.rows())));
    };
    return measureOnBench (request, guide);
}
} // namespace antinode
