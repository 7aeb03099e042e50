#include "Tolerance.h"

#include <antinode_base/MessageText.h>
#include <antinode_documents/ToleranceFile.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Tolerance.h>
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

DetuningSpread chooseSpread (const ToleranceRequest& request, const ModalModel& model, const FocusDescription& focus)
{
    const auto usual = focus.allocation.robust ? focus.allocation.robust->spread : spreadOf (model.origin);
    return { request.frequency.value_or (usual.frequency), request.damping.value_or (usual.damping),
             request.participation.value_or (usual.participation), request.drift.value_or (usual.drift) };
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

std::vector<Field> spreadFields (ToleranceRequest& request)
{
    const auto deviation = [] (const char* option, std::optional<double>& value, double most, const char* of)
    {
        return Field (option, &value, std::string ("Standard deviation of ") + of)
            .in (percent)
            .within (0, most)
            .by ("those of the robust design, else by the origin of the modes");
    };
    return { Field ("--draws", &request.draws, "Number of random devices").within (1, 1000000),
             Field ("--seed", &request.seed, "Seed of the random devices").within (0, std::numeric_limits<int>::max()),
             deviation ("--frequency-percent", request.frequency, 10, "each frequency, %"),
             deviation ("--damping-percent", request.damping, 50, "each damping, %"),
             deviation ("--participation-percent", request.participation, 50, "each participation, %"),
             deviation ("--drift-percent", request.drift, 10, "a common drift of all frequencies, %") };
}

std::vector<Field> fields (ToleranceRequest& request)
{
    auto all = fields (request.design);
    all.front().value = FocusOrDesign { &request.design.focus, &request.made };
    append (all, spreadFields (request));
    return all;
}

DesignOnDevices tolerance (const ToleranceRequest& request, const ShowProgress& progress)
{
    constexpr int worthKeeping = 1000; // draws: fewer are done in a second
    const auto designed =
        request.made ? request.made : std::make_shared<const DesignedFocus> (design (request.design, progress));
    const auto& asked = designed->made.design;
    auto model = ownModel (*designed);
    const ToleranceOptions settings { chooseSpread (request, model, asked.description), request.draws,
                                      static_cast<std::uint64_t> (request.seed) };
    const auto show = [&] (double share)
    {
        if (progress)
            progress ("Drawing devices", share);
    };
    const auto isKept = ! request.folder.empty() && settings.draws > worthKeeping;
    const auto evaluate = [&] (const char* name, const FocusDesign& evaluated)
    {
        return DesignTolerance { name, peakVoltage (evaluated),
                                 isKept ? resumableTolerance (request.folder, model, evaluated, settings, show)
                                        : evaluateTolerance (model, evaluated, settings, show) };
    };

    if (! asked.description.allocation.robust)
    {
        auto one = evaluate ("nominal", asked);
        return { designed, std::move (model), { std::move (one) } };
    }

    auto description = asked.description;
    description.allocation.robust.reset();
    const auto nominal = designFocus (model, description, asked.playback, DesignExtent::playable);
    std::vector<DesignTolerance> both { evaluate ("nominal", nominal), evaluate ("robust", asked) };
    return { designed, std::move (model), std::move (both) };
}

void writeTolerances (OutputFolder& folder, const DesignOnDevices& played)
{
    folder.write ("tolerance.json", toleranceToJson (played.model, played.focus(), played.tolerances).dump (2) + "\n");
    folder.write ("tolerance.html", renderReport (toleranceReport (played.model, played.focus(), played.tolerances)));
}

std::string tolerancesInWords (const DesignOnDevices& played)
{
    const auto& designs = played.tolerances;
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
            text += "  " + causeSentence (tolerance.causes[i], played.model) + "\n";
    }

    return text;
}
} // namespace antinode
