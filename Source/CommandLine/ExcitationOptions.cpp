#include "ExcitationOptions.h"

#include "CommonOptions.h"

#include <antinode_base/InputError.h>
#include <antinode_library/Inputs.h>
#include <antinode_text/JsonText.h>
#include <antinode_text/WaveFile.h>
#include <antinode_text/WaveReader.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double linesPerWidth = 4, minimumResolution = 0.1, maximumResolution = 10; // Hz
constexpr double restOfSettling = 1e-5;
constexpr double highestByDefault = 20000; // Hz
constexpr double levelShare = 0.2;

ExcitationSignal signalNamed (const std::string& name)
{
    return name == "sweep"   ? ExcitationSignal::sweep
           : name == "noise" ? ExcitationSignal::noise
                             : ExcitationSignal::multisine;
}

Eigen::VectorXd playedLevels (const ExcitationOptions& options, const Eigen::VectorXd& limits)
{
    const auto given = static_cast<Eigen::Index> (options.levels.size());

    if (given == 0)
        return levelShare * limits;

    if (given == 1)
        return Eigen::VectorXd::Constant (limits.size(), options.levels.front());

    if (given != limits.size())
        throw InputError ("--level-v", "is given " + std::to_string (given)
                                           + " times; allowed: once, or once for each of the "
                                           + std::to_string (limits.size()) + " ceramics");

    return Eigen::Map<const Eigen::VectorXd> (options.levels.data(), given);
}

/** Missing options are derived from the modes. */
void chooseForModes (ExcitationSettings& settings, const ModalModel& model, const ExcitationOptions& options)
{
    constexpr double rateShare = 0.45, beyond = 1.1;
    const Eigen::ArrayXd decay = decayRates (model).array();
    settings.lowestFrequency = options.lowest.value_or (std::max (1.0, model.frequencyHz (0) / 2));
    settings.highestFrequency = options.highest.value_or (
        std::min ({ highestByDefault, rateShare * options.rate, beyond * model.frequencyHz (model.modes() - 1) }));
    settings.resolution = options.resolution.value_or (
        std::clamp (decay.minCoeff() / (std::numbers::pi * linesPerWidth), minimumResolution, maximumResolution));
    const auto settlingTime = -std::log (restOfSettling) / decay.minCoeff();
    settings.settlingPeriods =
        options.settling.value_or (std::max (1, static_cast<int> (std::ceil (settlingTime * settings.resolution))));
}
} // namespace

void addExcitationOptions (CLI::App& command, ExcitationOptions& options)
{
    command.add_option ("--device", options.device, "Device: an embedded name or a .json file")->required();
    command
        .add_option ("--set", options.assignments, "Overrides a key, for example device.thickness_mm=1.5 (repeatable)")
        ->allow_extra_args (false)
        ->type_name ("KEY=VALUE");
    addCacheFlag (command, options.usesCache);
    command.add_option ("--signal", options.signal, "Excitation signal, played by one ceramic after the other")
        ->check (CLI::IsMember ({ "multisine", "sweep", "noise" }))
        ->capture_default_str();
    command.add_option ("--rate", options.rate, "Sample rate, Hz")->capture_default_str();
    command.add_option ("--lowest-hz", options.lowest, "Lower end of the band, Hz; default: half the lowest mode");
    command.add_option ("--highest-hz", options.highest,
                        "Upper end of the band, Hz; default: 20 kHz or the highest mode");
    command.add_option ("--resolution-hz", options.resolution,
                        "Largest spacing of lines, Hz; default: a quarter of the narrowest mode's width");
    command.add_option ("--periods", options.periods, "Number of measured periods")->capture_default_str();
    command.add_option ("--settling", options.settling,
                        "Number of periods before them; default: until the slowest mode has settled");
    command.add_option ("--sweep-s", options.sweepDuration, "Duration of a sweep, s")->capture_default_str();
    command.add_flag ("--odd", options.hasOddLines, "Uses a multisine of odd lines with gaps, which shows distortion");
    command.add_option ("--seed", options.seed, "Seed of noise and gaps")
        ->check (CLI::Range (0, 2000000000))
        ->capture_default_str();
    command
        .add_option (
            "--level-v", options.levels,
            "Peak voltage of all ceramics, or of each in order, V; default: a fifth of their limits (repeatable)")
        ->allow_extra_args (false);
}

ModalModel excitedDevice (const ExcitationOptions& options)
{
    checkAssignments (options.assignments);
    auto model = solveDevice (loadDevice (options.device, options.assignments), {}, options.usesCache);
    checkExcitable (model);
    return model;
}

void checkExcitable (const ModalModel& model)
{
    if (model.actuators() == 0 || model.modes() == 0)
        throw InputError ("device '" + model.name + "'", "has no ceramics or no modes; nothing can be excited");
}

ExcitationSheet excitationFor (const ModalModel& model, const ExcitationOptions& options)
{
    ExcitationSheet sheet;
    sheet.device = model.name;
    sheet.fullScaleVoltage = model.fullScaleVoltage;
    sheet.voltageLimits = voltageLimits (model);

    for (const auto& ceramic : model.ceramics)
        sheet.ceramics.push_back (ceramic.name);

    ExcitationSettings settings;
    settings.signal = signalNamed (options.signal);
    settings.sampleRate = options.rate;
    settings.periods = options.periods;
    settings.sweepDuration = options.sweepDuration;
    settings.hasOddGrid = options.hasOddLines;
    settings.seed = static_cast<std::uint64_t> (options.seed);
    settings.levels = playedLevels (options, sheet.voltageLimits);
    chooseForModes (settings, model, options);
    sheet.excitation = makeExcitation (settings, sheet.voltageLimits);
    // As files and audio devices hold it, so that a sheet in memory is the one that its file gives.
    sheet.excitation.signal = sheet.excitation.signal.cast<float>().cast<double>();
    return sheet;
}
} // namespace antinode
