#include "Excite.h"

#include <antinode_base/InputError.h>
#include <antinode_documents/ExcitationFile.h>
#include <antinode_documents/Library.h>
#include <antinode_text/WaveFile.h>

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

Eigen::VectorXd playedLevels (const ExcitationRequest& request, const Eigen::VectorXd& limits)
{
    const auto given = static_cast<Eigen::Index> (request.levels.size());

    if (given == 0)
        return levelShare * limits;

    if (given == 1)
        return Eigen::VectorXd::Constant (limits.size(), request.levels.front());

    if (given != limits.size())
        throw InputError ("--level-v", "is given " + std::to_string (given)
                                           + " times; allowed: once, or once for each of the "
                                           + std::to_string (limits.size()) + " ceramics");

    return Eigen::Map<const Eigen::VectorXd> (request.levels.data(), given);
}

/** What is missing is derived from the modes. */
void chooseForModes (ExcitationSettings& settings, const ModalModel& model, const ExcitationRequest& request)
{
    constexpr double rateShare = 0.45, beyond = 1.1;
    const Eigen::ArrayXd decay = decayRates (model).array();
    settings.lowestFrequency = request.lowest.value_or (std::max (1.0, model.frequencyHz (0) / 2));
    settings.highestFrequency = request.highest.value_or (std::min (
        { highestByDefault, rateShare * request.sampleRate, beyond * model.frequencyHz (model.modes() - 1) }));
    settings.resolution = request.resolution.value_or (
        std::clamp (decay.minCoeff() / (std::numbers::pi * linesPerWidth), minimumResolution, maximumResolution));
    const auto settlingTime = -std::log (restOfSettling) / decay.minCoeff();
    settings.settlingPeriods =
        request.settling.value_or (std::max (1, static_cast<int> (std::ceil (settlingTime * settings.resolution))));
}
} // namespace

std::vector<Field> fields (ExcitationRequest& request)
{
    return {
        Field ("--device", &request.device, "Device: an embedded name or a .json file").required().positional(),
        Field ("--signal", &request.signal, "Excitation signal, played by the ceramics in turn")
            .oneOf ({ "multisine", "sweep", "noise" }),
        Field ("--rate", &request.sampleRate, "Sample rate, Hz").as ("sample_rate_Hz"),
        Field ("--lowest-hz", &request.lowest, "Lower end of the band, Hz")
            .as ("lowest_frequency_Hz")
            .by ("half the lowest mode"),
        Field ("--highest-hz", &request.highest, "Upper end of the band, Hz")
            .as ("highest_frequency_Hz")
            .by ("20 kHz or the highest mode"),
        Field ("--resolution-hz", &request.resolution, "Largest spacing of lines, Hz")
            .as ("resolution_Hz")
            .by ("a quarter of the narrowest mode's width"),
        Field ("--periods", &request.periods, "Number of measured periods"),
        Field ("--settling", &request.settling, "Number of periods before them")
            .as ("settling_periods")
            .by ("until the slowest mode has settled"),
        Field ("--sweep-s", &request.sweepDuration, "Duration of a sweep, s"),
        Field ("--odd", &request.hasOddLines, "Uses a multisine of odd lines with gaps, which shows distortion"),
        Field ("--seed", &request.seed, "Seed of noise and gaps").within (0, 2e9),
        Field ("--level-v", &request.levels,
               "Peak voltage of all ceramics, or of each in order, V; none: a fifth of their limits (repeatable)")
            .as ("levels_V"),
        cacheField (request.usesCache),
    };
}

ModalModel excitedModel (const DeviceDescription& device, bool usesCache)
{
    auto model = solveDevice (device, {}, usesCache);

    if (model.actuators() == 0 || model.modes() == 0)
        throw InputError ("device '" + model.name + "'", "has no ceramics or no modes; nothing can be excited");

    return model;
}

ExcitationSheet excitationFor (const ModalModel& model, const ExcitationRequest& request)
{
    ExcitationSheet sheet;
    sheet.device = model.name;
    sheet.fullScaleVoltage = model.fullScaleVoltage;
    sheet.voltageLimits = voltageLimits (model);

    for (const auto& ceramic : model.ceramics)
        sheet.ceramics.push_back (ceramic.name);

    ExcitationSettings settings;
    settings.signal = signalNamed (request.signal);
    settings.sampleRate = request.sampleRate;
    settings.periods = request.periods;
    settings.sweepDuration = request.sweepDuration;
    settings.hasOddGrid = request.hasOddLines;
    settings.seed = static_cast<std::uint64_t> (request.seed);
    settings.levels = playedLevels (request, sheet.voltageLimits);
    chooseForModes (settings, model, request);
    sheet.excitation = makeExcitation (settings, sheet.voltageLimits);
    // As files and audio devices hold it, so that a sheet in memory is the one that its file gives.
    sheet.excitation.signal = sheet.excitation.signal.cast<float>().cast<double>();
    return sheet;
}

ExcitationSheet excite (const ExcitationRequest& request, const ShowProgress&)
{
    return excitationFor (excitedModel (request.device, request.usesCache), request);
}

Eigen::MatrixXd playedRuns (const ExcitationSheet& sheet)
{
    constexpr double maximumBytes = 512.0 * 1024 * 1024, bytesPerSample = 4;
    const auto& excitation = sheet.excitation;
    const auto ceramics = excitation.ceramics(), samples = ceramics * excitation.runLength;

    if (static_cast<double> (samples) * static_cast<double> (ceramics + 1) * bytesPerSample > maximumBytes)
        throw InputError ("excitation", "would make a file of more than 512 MiB; choose fewer periods, a coarser "
                                        "resolution or a lower rate, or use `antinode measure`, which needs no file");

    Eigen::MatrixXd played (ceramics + 1, samples);

    for (Eigen::Index i = 0; i < ceramics; ++i)
        played.middleCols (i * excitation.runLength, excitation.runLength) =
            playedRun (excitation, i, sheet.fullScaleVoltage);

    return played;
}

void writeExcitation (const std::filesystem::path& path, const ExcitationSheet& sheet)
{
    OutputFolder folder (path);
    folder.write ("excitation.wav", encodeWave (playedRuns (sheet), 1, sheet.excitation.settings.sampleRate));
    writeSheet (folder, sheet);
    folder.commit();
}
} // namespace antinode
