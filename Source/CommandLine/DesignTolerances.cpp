#include "DesignTolerances.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_documents/ToleranceFile.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/ExpectedError.h>
#include <antinode_reports/ToleranceReport.h>
#include <antinode_sweep/ResumableTolerance.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <limits>

namespace antinode
{
namespace
{
constexpr double percent = 100;
constexpr std::size_t shownCauses = 3;

constexpr double maximumFrequencyPercent = 10, maximumOtherPercent = 50; // %

/** A requested spread, or the default. CLI::Range would accept NaN. */
double spreadOr (const std::optional<double>& asked, const char* option, double maximum, double otherwise)
{
    if (! asked)
        return otherwise;

    if (! (*asked >= 0 && *asked <= maximum))
        throw InputError (option, "is " + inWords (*asked) + " %; allowed: 0 to " + inWords (maximum) + " %");

    return *asked / percent;
}

DetuningSpread chooseSpread (const ToleranceCommandOptions& options, const ModalModel& model,
                             const FocusDescription& focus)
{
    const auto usual = focus.allocation.robust ? focus.allocation.robust->spread : spreadOf (model.origin);
    return { spreadOr (options.frequency, "--frequency-percent", maximumFrequencyPercent, usual.frequency),
             spreadOr (options.damping, "--damping-percent", maximumOtherPercent, usual.damping),
             spreadOr (options.participation, "--participation-percent", maximumOtherPercent, usual.participation),
             spreadOr (options.drift, "--drift-percent", maximumFrequencyPercent, usual.drift) };
}

std::string row (const std::string& name, const Percentiles& values, const char* format)
{
    std::array<char, 64> cell {};
    std::snprintf (cell.data(), cell.size(), "  %-22s", name.c_str());
    std::string text = cell.data();

    for (const auto value : values)
    {
        std::snprintf (cell.data(), cell.size(), format, value);
        text += cell.data();
    }

    return text + "\n";
}

Percentiles inPercent (Percentiles values)
{
    for (auto& value : values)
        value *= percent;

    return values;
}
} // namespace

void addToleranceOptions (CLI::App& command, ToleranceCommandOptions& options)
{
    auto* const wanted = command.add_flag ("--tolerance", options.isWanted,
                                           "Computes the field error on devices that differ from the model");
    const auto add = [&] (const char* name, auto& value, const char* text)
    { return command.add_option (name, value, text)->needs (wanted); };
    add ("--draws", options.draws, "Number of random devices")->check (CLI::Range (1, 1000000))->capture_default_str();
    add ("--seed", options.seed, "Seed of the random devices")
        ->check (CLI::Range (0, std::numeric_limits<int>::max()))
        ->capture_default_str();
    add ("--frequency-percent", options.frequency,
         "Standard deviation of each frequency, %; default: by the origin of the modes");
    add ("--damping-percent", options.damping,
         "Standard deviation of each damping, %; default: by the origin of the modes");
    add ("--participation-percent", options.participation,
         "Standard deviation of each participation, %; default: by the origin of the modes");
    add ("--drift-percent", options.drift,
         "Standard deviation of a common drift of all frequencies, %; default: by the origin of the modes");
}

std::vector<DesignTolerance> designTolerances (const ModalModel& model, const FocusDesign& design,
                                               const ToleranceCommandOptions& options,
                                               const std::filesystem::path& folder, const ShowProgress& progress)
{
    constexpr int worthKeeping = 1000; // draws: fewer are done in a second
    const ToleranceOptions settings { chooseSpread (options, model, design.description), options.draws,
                                      static_cast<std::uint64_t> (options.seed) };
    const auto show = [&] (double share)
    {
        if (progress)
            progress ("Drawing devices", share);
    };
    const auto isKept = ! folder.empty() && settings.draws > worthKeeping;
    const auto evaluate = [&] (const char* name, const FocusDesign& evaluated)
    {
        return DesignTolerance { name, peakVoltage (evaluated),
                                 isKept ? resumableTolerance (folder, model, evaluated, settings, show)
                                        : evaluateTolerance (model, evaluated, settings, show) };
    };

    if (! design.description.allocation.robust)
        return { evaluate ("nominal", design) };

    auto description = design.description;
    description.allocation.robust.reset();
    const auto nominal = designFocus (model, description, design.playback, DesignExtent::playable);
    return { evaluate ("nominal", nominal), evaluate ("robust", design) };
}

void writeTolerances (OutputFolder& folder, const ModalModel& model, const std::string& focus,
                      const std::vector<DesignTolerance>& tolerances)
{
    folder.write ("tolerance.json", toleranceToJson (model, focus, tolerances).dump (2) + "\n");
    folder.write ("tolerance.html", renderReport (toleranceReport (model, focus, tolerances)));
}

std::string tolerancesInWords (const ModalModel& model, const std::vector<DesignTolerance>& designs)
{
    const auto& options = designs.front().tolerance.options;
    auto text = std::to_string (options.draws)
                + " random devices; standard deviations: " + inWords (percent * options.spread.frequency)
                + " % in frequency, " + inWords (percent * options.spread.damping) + " % in damping, "
                + inWords (percent * options.spread.participation) + " % in participation, "
                + inWords (percent * options.spread.drift) + " % by a drift of all frequencies\n";
    text += row ("percentile", tolerancePercents, "%9.0f");

    for (const auto& design : designs)
    {
        const auto& tolerance = design.tolerance;
        text += design.name + ", peak " + inWords (design.peakVoltage) + " V\n";
        text += row ("v-score", tolerance.vScore, "%9.4f");
        text += row ("field error (%)", inPercent (tolerance.fieldError), "%9.2f");
        text += row ("peak ratio", tolerance.peakRatio, "%9.4f");

        for (std::size_t i = 0; i < std::min (shownCauses, tolerance.causes.size()); ++i)
            text += "  " + causeSentence (tolerance.causes[i], model) + "\n";
    }

    return text;
}
} // namespace antinode
