#include "AudioBench.h"

#include "Measuring.h"

#include <antinode_audio/IdentifyTone.h>
#include <antinode_audio/Interruption.h>
#include <antinode_audio/QuietLibraries.h>
#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Progress.h>
#include <antinode_measurement/SimulatedBench.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace antinode
{
namespace
{
/** The channels of several roles, ascending. @throws InputError  where two roles share one */
std::vector<int> distinct (std::vector<int> wanted, const std::string& kind)
{
    std::sort (wanted.begin(), wanted.end());

    if (const auto twice = std::adjacent_find (wanted.begin(), wanted.end()); twice != wanted.end())
        throw InputError (kind + " " + std::to_string (*twice + 1), "has two roles; allowed: one");

    return wanted;
}

std::vector<int> usedOutputs (const BenchChannels& channels, Eigen::Index ceramics)
{
    std::vector<int> outputs (static_cast<std::size_t> (ceramics));
    std::iota (outputs.begin(), outputs.end(), 0);
    outputs.push_back (channels.syncOutput);
    return distinct (outputs, "output");
}

std::vector<int> usedInputs (const BenchChannels& channels)
{
    auto inputs = channels.sensors;

    if (channels.syncInput >= 0)
        inputs.push_back (channels.syncInput);

    return distinct (inputs, "input");
}

/** Where an open channel stands among the open ones. */
Eigen::Index channelColumn (const std::vector<int>& open, int channel)
{
    return std::find (open.begin(), open.end(), channel) - open.begin();
}

/** Of the open channels of a device. */
TakeLayout takeLayout (const BenchChannels& channels, Eigen::Index ceramics, double fullScale, double velocity)
{
    const auto outputs = usedOutputs (channels, ceramics), inputs = usedInputs (channels);
    TakeLayout layout;
    layout.syncOutput = channelColumn (outputs, channels.syncOutput);
    layout.syncInput = channels.syncInput >= 0 ? channelColumn (inputs, channels.syncInput) : -1;
    layout.fullScale = fullScale;
    layout.velocity = velocity;

    for (Eigen::Index k = 0; k < ceramics; ++k)
        layout.ceramics.push_back (channelColumn (outputs, static_cast<int> (k)));

    for (const auto sensor : channels.sensors)
        layout.sensors.push_back (channelColumn (inputs, sensor));

    return layout;
}
} // namespace

AudioBench::AudioBench (AudioChoice choice, const BenchChannels& channels, Eigen::Index ceramics, double fullScale,
                        double fullScaleVelocity)
    : TakeBench (takeLayout (channels, ceramics, fullScale, fullScaleVelocity))
{
    choice.outputs = usedOutputs (channels, ceramics);
    choice.inputs = usedInputs (channels);
    openAudio (manager, choice);
    protectRamps();
    manager.addAudioCallback (&player);
}

AudioBench::QuietLibraries::QuietLibraries()
{
    silenceAudioLibraries();
}

AudioBench::~AudioBench()
{
    manager.removeAudioCallback (&player);
    manager.closeAudioDevice();
}

double AudioBench::sampleRate() const
{
    auto* const device = manager.getCurrentAudioDevice();
    return device != nullptr ? device->getCurrentSampleRate() : 0;
}

namespace
{
constexpr double offsetShare = 0.01; // of the limit: an offset that amplifiers without a fault stay below
constexpr std::size_t shownResonances = 4;

/** What all steps are about. */
struct CheckedBench
{
    const ModalModel& model;
    const ExcitationSheet& sheet;
    const Eigen::MatrixX2d& points;
    const BenchChannels& channels;
    const SensorScale& sensor;
    std::vector<ExcitationLoad> loads;
};

double toneVolts (const CheckedBench& bench, std::size_t ceramic)
{
    return IdentifyTone::amplitude (voltageLimit (bench.model, ceramic));
}

std::string threeDigits (double value)
{
    return formatted ("%.3g", value);
}

/** "12.3 mm/s", and where the sensor is known what it gives in volts and how far below the input's full scale. */
std::string velocityInWords (double velocity, const SensorScale& sensor)
{
    auto text = threeDigits (velocity * milli) + " mm/s";

    if (! (sensor.sensitivity > 0) || ! (velocity > 0))
        return text;

    const auto volts = velocity * milli / sensor.sensitivity;
    return text
           + formatted (" = %s V, %.0f dB of full scale", threeDigits (volts).c_str(),
                        20 * std::log10 (volts / sensor.inputFullScale));
}

/** 0 is unknown. */
std::string knownOr (double value, const char* unit)
{
    return value > 0 ? threeDigits (value) + " " + unit : "unknown";
}

std::string wiring (const CheckedBench& bench)
{
    const auto& [model, sheet, points, channels, sensor, loads] = bench;
    std::string text = "1. Connect, with the amplifiers off and the ceramics apart:\n"
                       "   output  ceramic           a sample of 1 gives  limit       plays at most  capacitance  "
                       "peak current\n";

    for (std::size_t i = 0; i < model.ceramics.size(); ++i)
    {
        const auto& ceramic = model.ceramics[i];
        text += formatted (
            "   %-6d  %-16s  %-19s  %-10s  %-13s  %-11s  %s\n",
            i < channels.outputs.size() ? channels.outputs[i] + 1 : static_cast<int> (i) + 1, ceramic.name.c_str(),
            knownOr (model.fullScaleVoltage, "V").c_str(), knownOr (voltageLimit (model, i), "V").c_str(),
            knownOr (sheet.excitation.settings.levels[static_cast<Eigen::Index> (i)], "V").c_str(),
            knownOr (ceramic.capacitance * nano, "nF").c_str(), knownOr (loads[i].current * milli, "mA").c_str());
    }

    text += formatted ("   %-6d  ", channels.syncOutput + 1)
            + (channels.syncInput >= 0
                   ? formatted ("by a cable to input %d: the sync channel, half of full scale, no amplifier\n",
                                channels.syncInput + 1)
                   : std::string ("nothing: no sync input, the latency is that of --latency-ms\n"));

    for (const auto input : channels.sensors)
        text += formatted ("   input %d: sensor", input + 1)
                + (sensor.sensitivity > 0 ? ", " + inWords (sensor.sensitivity) + " mm/s per V; full scale: "
                                                + inWords (sensor.inputFullScale) + " V = "
                                                + inWords (sensor.inputFullScale * sensor.sensitivity) + " mm/s\n"
                                          : std::string ("; --sensitivity-mm-s-per-v gives these levels in volts\n"));

    return text;
}

/** A sentence for each ceramic whose amplifier would be asked for more than it has. */
std::string overloads (const CheckedBench& bench)
{
    std::string text;

    for (std::size_t i = 0; i < bench.loads.size(); ++i)
        if (const auto level = bench.sheet.excitation.settings.levels[static_cast<Eigen::Index> (i)];
            bench.loads[i].highestLevel > 0 && level > bench.loads[i].highestLevel)
            text += "   TOO MUCH for the amplifier of ceramic '" + bench.model.ceramics[i].name + "': "
                    + inWords (bench.loads[i].slew / micro) + " V/us, " + knownOr (bench.loads[i].current * milli, "mA")
                    + "; its limits allow --level-v " + inWords (bench.loads[i].highestLevel) + "\n";

    return text;
}

std::string meterSteps (const CheckedBench& bench)
{
    const auto& model = bench.model;
    double tone = toneVolts (bench, 0), lowestTone = tone, offset = voltageLimit (model, 0);

    for (std::size_t i = 1; i < model.ceramics.size(); ++i)
    {
        tone = std::max (tone, toneVolts (bench, i));
        lowestTone = std::min (lowestTone, toneVolts (bench, i));
        offset = std::min (offset, voltageLimit (model, i));
    }

    const auto volts = lowestTone < tone ? inWords (lowestTone) + " to " + inWords (tone) : inWords (tone);
    return "2. Multimeter at the wires of each ceramic, discharged, connected to nothing: the capacitance above within "
           "20 %,\n   a resistance above 1 MOhm. Much less capacitance: a broken wire or ceramic; half or double: the "
           "series or\n   parallel wiring of a bimorph.\n"
           "3. Switch on antinode-standalone with this device (it starts disarmed), the interface, the amplifiers.\n"
           "   Multimeter, V DC, at each amplifier's output: below "
           + inWords (offsetShare * offset)
           + " V. More: an offset, which stays on the ceramic.\n"
             "4. Arm. Settings, Routing, Identify, one ceramic after the other. Scope at that amplifier's output: "
             "bursts of "
           + inWords (IdentifyTone::frequency) + " Hz,\n   " + volts
           + " V peak. Another value: the gain differs from what a sample of 1 gives by this ratio.\n"
             "   Nothing, or at another output: the routing or the cables.\n"
             "5. Disarm. Switch the amplifiers off, wait until their outputs are at 0 V, connect the ceramics, switch "
             "them on, arm.\n   Identify: each tone is felt at its own ceramic.\n";
}

/** What to change where the sensor's input would clip. */
std::string clippingAdvice (const CheckedBench& bench, const std::vector<ExpectedSignal>& expected)
{
    constexpr double headroom = 0.5;
    const auto fullScale = bench.sensor.inputFullScale * bench.sensor.sensitivity / milli;
    auto level = std::numeric_limits<double>::infinity();

    for (std::size_t i = 0; i < expected.size(); ++i)
        if (expected[i].peak > fullScale)
            level = std::min (level, headroom * fullScale / expected[i].peak
                                         * bench.sheet.excitation.settings.levels[static_cast<Eigen::Index> (i)]);

    return fullScale > 0 && std::isfinite (level)
               ? "   THE INPUT WOULD CLIP: --level-v " + threeDigits (level)
                     + " leaves half of its range, or choose a larger range of the sensor or the input.\n"
               : std::string();
}

std::string expectedSteps (const CheckedBench& bench)
{
    const auto& [model, sheet, points, channels, sensor, loads] = bench;
    const auto& settings = sheet.excitation.settings;
    const Eigen::RowVectorXd shapes = shapesAt (model, points (0, 0), points (0, 1));
    const auto expected = expectedSignals (model, shapes, sheet.excitation);
    auto text = "6. Sensor at point 1: " + inWords (points (0, 0) * milli) + ", " + inWords (points (0, 1) * milli)
                + " mm. In the standalone program, Settings, Audio device, choose its input:\n"
                  "   its spectrum shows the tone of Identify, in the measurement the resonances.\n"
                  "   ceramic           peak of the tone                                      measurement: peak"
                  "                                     RMS\n";

    for (std::size_t i = 0; i < model.ceramics.size(); ++i)
    {
        const auto tone = toneVolts (bench, i)
                          * expectedResponse (model, shapes, static_cast<Eigen::Index> (i), IdentifyTone::frequency);
        text += formatted ("   %-16s  %-52s  %-52s  %s mm/s\n", model.ceramics[i].name.c_str(),
                           velocityInWords (tone, sensor).c_str(), velocityInWords (expected[i].peak, sensor).c_str(),
                           threeDigits (expected[i].effective * milli).c_str());
    }

    text += clippingAdvice (bench, expected) + "   Strongest at:";

    for (const auto& each :
         strongestResonances (model, shapes, settings.lowestFrequency, settings.highestFrequency, shownResonances))
        text += formatted ("\n   %.0f Hz, ", each.frequency) + threeDigits (each.response * milli)
                + " mm/s per V from '" + model.ceramics[static_cast<std::size_t> (each.ceramic)].name + "'";

    return text + "\n";
}

/** What the level check, which plays another signal, says at the first point. */
double levelCheckVelocity (const CheckedBench& bench)
{
    const auto quiet = levelCheckExcitation (bench.sheet);
    const auto expected =
        expectedSignals (bench.model, shapesAt (bench.model, bench.points (0, 0), bench.points (0, 1)), quiet);
    double largest = 0;

    for (std::size_t i = 0; i < expected.size(); ++i)
    {
        const auto ceramic = static_cast<Eigen::Index> (i);
        largest = std::max (largest, expected[i].peak * bench.sheet.excitation.settings.levels[ceramic]
                                         / quiet.settings.levels[ceramic]);
    }

    return largest;
}

std::string measuringSteps (const CheckedBench& bench)
{
    const auto& excitation = bench.sheet.excitation;
    const auto rate = excitation.settings.sampleRate;
    const auto sensors = std::ssize (bench.channels.sensors), points = bench.points.rows();
    const auto runs = (points + sensors - 1) / sensors * excitation.ceramics();
    const auto run = static_cast<double> (excitation.runLength) / rate;
    const auto check =
        static_cast<double> (levelCheckExcitation (bench.sheet).runLength * excitation.ceramics()) / rate;
    const auto isInWindow = ! bench.channels.outputs.empty();
    const std::string begin =
        isInWindow ? "7. Measure here."
                   : "7. Disarm and close the standalone program: the interface serves one program. Give the command "
                     "without --checklist.";
    return begin + "\n   Its level check should give about "
           + velocityInWords (levelCheckVelocity (bench), bench.sensor)
           + ".\n   A third or three times as much: the sensor's range, the gain, the glue, or a device that differs "
             "from "
             "its file.\n"
           + formatted ("8. Time: %td points with %td sensor%s x %td ceramics x %.1f s = %s of playing", points,
                        sensors, sensors == 1 ? "" : "s", excitation.ceramics(), run,
                        durationInWords (static_cast<double> (runs) * run + check).c_str())
           + ", and what moving the sensor takes.\n"
             "9. To stop: "
           + (isInWindow ? "MUTE ALL (F12), Escape or Stop" : "Ctrl+C")
           + ", all outputs are at 0 V after 20 ms. Amplifiers off before a wire is touched; "
             "ceramics "
             "keep\n   their charge: discharge them through 100 kOhm.\n";
}
} // namespace

std::string benchChecklist (const ModalModel& model, const ExcitationSheet& sheet, const Eigen::MatrixX2d& points,
                            const BenchChannels& channels, const SensorScale& sensor)
{
    const CheckedBench bench { model, sheet, points, channels, sensor, excitationLoads (model, sheet.excitation) };
    const auto& settings = sheet.excitation.settings;
    return formatted (
               "Checklist: device '%s', %td ceramics, %td points, %.0f to %.0f Hz at %.0f Hz. Nothing is played.\n",
               model.name.c_str(), model.actuators(), points.rows(), settings.lowestFrequency,
               settings.highestFrequency, settings.sampleRate)
           + wiring (bench) + overloads (bench) + meterSteps (bench) + expectedSteps (bench) + measuringSteps (bench);
}
} // namespace antinode
