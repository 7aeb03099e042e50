#include "CalibrationFiles.h"
#include "Commands.h"
#include "FieldOptions.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/RandomNumbers.h>
#include <antinode_tasks/BenchFields.h>
#include <antinode_tasks/Excite.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <numbers>

namespace antinode
{
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
} // namespace antinode
