#include "Tradeoffs.h"

#include "Field.h"

#include <antinode_documents/Library.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_focus/LimitUse.h>
#include <antinode_reports/TradeoffReport.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <utility>

namespace antinode
{
namespace
{
/** What skin feels of the controlled modes, whatever the limits are. */
FindFeltContrast feltContrasts (const ModalModel& model, Playback playback)
{
    RenderOptions render;
    render.playback = playback;
    render.threshold = findSkinThreshold ({});
    return [unlimited = withoutVoltageLimits (model), render] (const FocusDesign& design)
    { return renderFocus (unlimited, design, render).felt.value().contrast(); };
}

/** With failures in the words of files and options. */
template <typename Found>
DesignTradeoff told (const FocusDescription& focus, const ModalModel& model, Found found)
{
    for (auto& point : found.points)
        point.failure = withKeysAndOptions (point.failure);

    return { focus.name, model.name, std::move (found) };
}

DesignTradeoff byMethods (const ModalModel& model, const FocusDescription& focus, Playback playback,
                          const ShowTradeoff& show)
{
    const auto tell = [&] (const Tradeoff& now)
    {
        if (show)
            show (told (focus, model, now), now.expectedShare);
    };
    return told (focus, model, sweepTradeoff (model, focus, playback, tell, feltContrasts (model, playback)));
}

DesignTradeoff byWeights (const Setup& setup, const FocusDescription& focus, const ShowTradeoff& show)
{
    RenderOptions render;
    render.playback = setup.playback;
    render.threshold = focus.threshold;
    const auto tell = [&] (const FeltTradeoff& now)
    {
        if (show)
            show (told (focus, setup.known, now),
                  static_cast<double> (now.points.size()) / static_cast<double> (now.planned));
    };
    return told (focus, setup.known, sweepFeltWeights (setup.wide, focus, render, setup.widen, tell));
}

/** What one of two functions gives for the designs that there are. */
template <typename ByMethods, typename ByWeights>
auto either (const DesignTradeoff& tradeoff, const ByMethods& methods, const ByWeights& weights)
{
    if (const auto* found = std::get_if<Tradeoff> (&tradeoff.found))
        return methods (*found, tradeoff.focus, tradeoff.device);

    return weights (std::get<FeltTradeoff> (tradeoff.found), tradeoff.focus, tradeoff.device);
}

std::string tradeoffTable (const DesignTradeoff& tradeoff)
{
    return std::holds_alternative<Tradeoff> (tradeoff.found)
               ? tradeoffToCsv (std::get<Tradeoff> (tradeoff.found))
               : feltTradeoffToCsv (std::get<FeltTradeoff> (tradeoff.found));
}
} // namespace

std::size_t DesignTradeoff::designs() const
{
    return std::visit ([] (const auto& each) { return each.points.size(); }, found);
}

std::size_t DesignTradeoff::planned() const
{
    return std::visit ([] (const auto& each) { return each.planned; }, found);
}

DesignTradeoff designTradeoff (const FocusRequest& request, const ShowTradeoff& show)
{
    const auto focus = focusOf (request);
    const auto playback = playbackOf (request);

    if (focus.felt)
    {
        const auto setup = setUp (request.device, playback, request.usesCache);
        checkKindOfPlaces (setup.known, focus);
        return byWeights (setup, focus, show);
    }

    const auto model = solveDevice (request.device, {}, request.usesCache);
    checkKindOfPlaces (model, focus);
    return byMethods (model, focus, playback, show);
}

DesignTradeoff tradeoff (const FocusRequest& request, const ShowProgress& show)
{
    return designTradeoff (request,
                           [&] (const DesignTradeoff&, double share)
                           {
                               if (show)
                                   show ("Designing", share);
                           });
}

nlohmann::ordered_json tradeoffDocument (const DesignTradeoff& tradeoff)
{
    return either (tradeoff, tradeoffToJson, feltTradeoffToJson);
}

ReportPage tradeoffPage (const DesignTradeoff& tradeoff)
{
    return either (tradeoff, tradeoffReport, feltTradeoffReport);
}

std::string tradeoffInWords (const DesignTradeoff& tradeoff)
{
    return std::holds_alternative<Tradeoff> (tradeoff.found)
               ? tradeoffToText (std::get<Tradeoff> (tradeoff.found))
               : feltTradeoffToText (std::get<FeltTradeoff> (tradeoff.found));
}

void writeTradeoff (const std::filesystem::path& path, const DesignTradeoff& tradeoff)
{
    OutputFolder folder (path);
    folder.write ("tradeoff.json", tradeoffDocument (tradeoff).dump (2) + "\n");
    folder.write ("tradeoff.csv", tradeoffTable (tradeoff));
    folder.write ("tradeoff.html", renderReport (tradeoffPage (tradeoff)));
    folder.commit();
}
} // namespace antinode
