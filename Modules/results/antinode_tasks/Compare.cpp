#include "Compare.h"

#include "Perform.h"
#include "Render.h"
#include "Tolerance.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_render/Summary.h>
#include <antinode_render/WaveformsTolerance.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

namespace antinode
{
namespace
{
constexpr std::size_t low = 0, high = tolerancePercents.size() - 1; // 19 of 20 devices are better

/** A case with all numbers of its summary. */
struct Scored
{
    ComparedCase shown;
    SeriesResult scores;
};

Scored scored (const ModalModel& model, const std::string& played, std::vector<std::pair<std::string, double>> numbers)
{
    SeriesResult scores { model.name + ": " + played, std::move (numbers), {} };
    ComparedCase shown;
    shown.device = model.name;
    shown.played = played;
    shown.ceramics = model.actuators();
    shown.peakVoltage = seriesNumber (scores, "peak_voltage_V");
    shown.voltageLimit = model.actuators() > 0 ? voltageLimits (model).maxCoeff() : ComparedCase::unknown;
    shown.peakCurrent = seriesNumber (scores, "peak_current_A");
    shown.energy = seriesNumber (scores, "energy_J");
    return { std::move (shown), std::move (scores) };
}

Scored playFocus (const CompareRequest& request, const DeviceDescription& device, const FocusDescription& focus)
{
    RenderRequest render;
    render.design.focus = focus;
    render.design.device = device;
    render.design.usesCache = request.usesCache;
    const auto rendered = antinode::render (render, {});
    const auto& played = rendered.focus;
    auto result = scored (played.known, focus.name, summaryNumbers (summaryToJson (played, rendered.outcome)));

    if (played.felt)
    {
        for (const auto& target : played.felt->targets)
            result.shown.levels.push_back (target.level);

        result.shown.contrast = played.felt->contrast().value_or (ComparedCase::unknown);
    }

    ToleranceRequest spread;
    spread.made = rendered.design;
    spread.devices = request.drawn;
    const auto error = 100 * tolerance (spread, {}).tolerances.back().tolerance.fieldError[high];
    result.shown.tolerance = "field error up to " + inWords (error) + " %";
    result.scores.numbers.emplace_back ("tolerance_field_error_percent", error);
    return result;
}

/** From the weakest finger with a track to whatever is strongest elsewhere, dB. */
double contrastOf (const PerformedWaveforms& performed)
{
    const auto& felt = performed.felt;
    const auto tracks = static_cast<std::ptrdiff_t> (performed.design.description.tracks.size());
    const auto isWeaker = [] (const FeltPlace& a, const FeltPlace& b) { return a.level < b.level; };
    const auto silent = felt.targets.begin() + tracks;
    auto strongest = felt.elsewhere ? felt.elsewhere->level : -std::numeric_limits<double>::infinity();

    if (silent != felt.targets.end())
        strongest = std::max (strongest, std::max_element (silent, felt.targets.end(), isWeaker)->level);

    return std::min_element (felt.targets.begin(), silent, isWeaker)->level - strongest;
}

Scored playWaveforms (const CompareRequest& request, const DeviceDescription& device,
                      const WaveformsDescription& waveforms)
{
    TrackSettings settings;
    settings.threshold = findSkinThreshold ({});
    const auto models = trackModels (device, request.usesCache);
    const auto [performed, share] = performWithinLimits (models, waveforms, settings);
    auto result = scored (performed.judge, waveforms.name, summaryNumbers (performedToJson (performed)));
    auto& [shown, scores] = result;
    const auto tracks = static_cast<Eigen::Index> (waveforms.tracks.size());

    for (Eigen::Index p = 0; p < tracks; ++p)
    {
        shown.levels.push_back (performed.felt.targets[static_cast<std::size_t> (p)].level);
        scores.numbers.emplace_back ("level_dB_SL_" + std::to_string (p + 1), shown.levels.back());
    }

    shown.missing = 20 * std::log10 (share);
    shown.contrast = contrastOf (performed);
    const auto drawn = waveformsTolerance (models.judge, performed.design, settings.threshold,
                                           toleranceOptions (request.drawn, spreadOf (models.judge.origin)), {});
    const Eigen::VectorXd weakest = drawn.levels.leftCols (tracks).rowwise().minCoeff();
    const Eigen::VectorXd worst = drawn.suppression.rowwise().maxCoeff();
    const auto level = computePercentiles ({ weakest.begin(), weakest.end() })[low];
    const auto error = computePercentiles ({ worst.begin(), worst.end() })[high];
    shown.tolerance = fixedText (level, 1) + " dB SL, error " + fixedText (error, 1) + " dB";
    scores.numbers.insert (scores.numbers.end(), { { "level_share_dB", shown.missing },
                                                   { "contrast_dB", shown.contrast },
                                                   { "tolerance_level_dB_SL", level },
                                                   { "tolerance_error_dB", error } });
    return result;
}

/** What is played, by its name. */
using Play = std::pair<std::string, std::function<Scored (const DeviceDescription&)>>;

std::vector<Play> playsOf (const CompareRequest& request)
{
    std::vector<Play> plays;

    for (const auto& focus : request.focuses)
        plays.emplace_back (focus.name, [&] (const auto& device) { return playFocus (request, device, focus); });

    if (request.waveforms)
        plays.emplace_back (request.waveforms->name,
                            [&, waveforms = placedWaveforms (*request.waveforms, request.at)] (const auto& device)
                            { return playWaveforms (request, device, waveforms); });

    return plays;
}

Scored playOn (const DeviceDescription& device, const Play& play)
{
    try
    {
        return play.second (device);
    }
    catch (const InputError& error)
    {
        Scored failed { {}, { device.name + ": " + play.first, {}, withKeysAndOptions (error.what()) } };
        failed.shown.device = device.name;
        failed.shown.played = play.first;
        failed.shown.error = failed.scores.error;
        return failed;
    }
}
} // namespace

std::vector<Field> fields (CompareRequest& request)
{
    std::vector<Field> all {
        Field ("devices", &request.devices, "Devices: embedded names or .json files").required().positional(),
        Field ("--focus", &request.focuses, "Focus that is played: an embedded name or a .json file (repeatable)")
            .as ("focuses"),
        Field ("--waveforms", OptionalWaveforms { &request.waveforms },
               "Waveforms that are played: an embedded name, a .json file or haptic content"),
    };

    for (auto& field : fields (request.at))
        all.push_back (field.with ("--waveforms"));

    append (all, fields (request.drawn));
    append (all, { Field ("--figures", &request.figures,
                          "Also writes the figures of the report for print: svg, pdf (repeatable)")
                       .oneOf ({ "svg", "pdf" }),
                   cacheField (request.usesCache) });
    return all;
}

ComparedDevices compare (const CompareRequest& request, const ShowProgress& show)
{
    const auto plays = playsOf (request);

    if (request.devices.empty() || plays.empty())
        throw InputError ("compare", "has nothing to compare; allowed: devices, and --focus or --waveforms");

    ComparedDevices compared;
    std::vector<SeriesResult> rows;
    const auto all = static_cast<double> (request.devices.size() * plays.size());

    for (const auto& device : request.devices)
        for (const auto& play : plays)
        {
            if (show)
                show ("Comparing devices", static_cast<double> (rows.size()) / all);

            auto [shown, scores] = playOn (device, play);
            compared.cases.push_back (std::move (shown));
            rows.push_back (std::move (scores));
        }

    compared.scores = scoreTable (rows);
    compared.figures = request.figures;
    return compared;
}

void writeCompared (const std::filesystem::path& path, const ComparedDevices& compared)
{
    OutputFolder folder (path);
    const auto page = comparisonReport (compared.cases);
    folder.write ("report.html", renderReport (page));
    folder.write ("compare.pdf", renderReportPdf (page));
    folder.write ("scores.csv", compared.scores);

    for (const auto& format : compared.figures)
        writeFigures (folder, page, format == "svg" ? VectorFormat::svg : VectorFormat::pdf);

    folder.commit();
}
} // namespace antinode
