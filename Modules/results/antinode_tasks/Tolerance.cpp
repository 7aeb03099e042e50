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

namespace antinode
{
namespace
{
constexpr double percent = 100;
constexpr std::size_t shownCauses = 3;

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

std::vector<Field> fields (ToleranceRequest& request)
{
    auto all = fields (request.design);
    all.front().value = FocusOrDesign { &request.design.focus, &request.made };
    append (all, fields (request.devices));
    return all;
}

DesignOnDevices tolerance (const ToleranceRequest& request, const ShowProgress& progress)
{
    constexpr int worthKeeping = 1000; // draws: fewer are done in a second
    const auto designed =
        request.made ? request.made : std::make_shared<const DesignedFocus> (design (request.design, progress));
    const auto& asked = designed->made.design;
    auto model = ownModel (*designed);
    const auto& robust = asked.description.allocation.robust;
    const auto settings = toleranceOptions (request.devices, robust ? robust->spread : spreadOf (model.origin));
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
    auto text = drawnInWords (designs.front().tolerance.options) + "\n";
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
