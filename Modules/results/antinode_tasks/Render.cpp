#include "Render.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/DesignFile.h>
#include <antinode_documents/Inputs.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_render/Summary.h>
#include <antinode_reports/FocusReport.h>
#include <antinode_reports/PlateCharts.h>
#include <antinode_reports/Report.h>
#include <antinode_responses/PointsFile.h>
#include <antinode_text/CsvText.h>
#include <antinode_text/MatlabWriter.h>
#include <antinode_text/TfwFile.h>
#include <antinode_text/WaveFile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

namespace antinode
{
namespace
{
constexpr double probeFullScale = 1; // m/s

std::string numbered (const char* format, std::size_t number)
{
    std::array<char, 64> text {};
    std::snprintf (text.data(), text.size(), format, number);
    return text.data();
}

void writeVoltagesCsv (OutputFolder& folder, const RenderedFocus& focus)
{
    std::vector<std::string> columns;

    for (std::size_t i = 0; i < focus.model.ceramics.size(); ++i)
        columns.push_back (numbered ("voltage_V_%zu", i + 1));

    folder.write ("voltages.csv", encodeCsv (outputVoltages (focus), columns, focus.render.sampleRate, 0));
}

/** One file per ceramic, and a sheet: a .tfw holds only the shape, the rest is set on the generator by hand. */
void writeVoltagesTfw (OutputFolder& folder, const RenderedFocus& focus)
{
    std::string sheet = "file,ceramic,amplitude_Vpp,offset_V,high_V,low_V,period_s\n";

    for (std::size_t i = 0; i < focus.model.ceramics.size(); ++i)
    {
        const auto file =
            encodeTfw (outputVoltages (focus).row (static_cast<Eigen::Index> (i)).transpose(), focus.render.sampleRate);
        const auto name = numbered ("voltages-%02zu.tfw", i + 1);
        folder.write (name, file.bytes);
        std::array<char, 256> numbers {};
        std::snprintf (numbers.data(), numbers.size(), ",%.9g,%.9g,%.9g,%.9g,%.12g\n", file.amplitudePeakToPeak,
                       file.offset, file.highVoltage, file.lowVoltage, file.period);
        sheet.append (name).append (",").append (std::to_string (i + 1)).append (numbers.data());
    }

    folder.write ("voltages-tfw.csv", sheet);
}

/** Samples in rows, as MATLAB's own functions take signals. */
void writeVoltagesMatlab (OutputFolder& folder, const RenderedFocus& focus)
{
    const auto& render = focus.render;
    const auto number = [] (double value) { return Eigen::MatrixXd::Constant (1, 1, value); };
    Eigen::MatrixXd probes (static_cast<Eigen::Index> (focus.probes.size()), 2);

    for (std::size_t i = 0; i < focus.probes.size(); ++i)
        probes.row (static_cast<Eigen::Index> (i)) << focus.probes[i].first * milli, focus.probes[i].second * milli;

    const auto on = pointsOn (focus.model.surface);
    const auto late = focus.undone ? static_cast<double> (focus.undone->lateness) : 0.0;
    folder.write ("voltages.mat",
                  encodeMatlabFile ({ { "voltages_V", outputVoltages (focus).transpose(), {} },
                                      { "sample_rate_Hz", number (render.sampleRate), {} },
                                      { "focus_sample", number (static_cast<double> (render.focusSample) + 1), {} },
                                      { "voltages_late_samples", number (late), {} },
                                      { "probes_mm", probes, {} },
                                      { "velocity_mm_s", (render.probeVelocities * milli).transpose(), {} },
                                      { "points_mm", focus.model.surface.points (on, Eigen::all) * milli, {} },
                                      { "wanted_mm_s", focus.design.target.field (on) * milli, {} },
                                      { "represented_mm_s", focus.design.truncatedField (on) * milli, {} },
                                      { "reached_mm_s", focus.reachedField (on) * milli, {} } }));
}

void writeProbes (OutputFolder& folder, const RenderedFocus& focus)
{
    std::vector<std::string> columns;

    for (std::size_t i = 0; i < focus.probes.size(); ++i)
        columns.push_back (numbered ("velocity_mm_s_%zu", i + 1));

    folder.write ("probe.csv", encodeCsv (focus.render.probeVelocities * milli, columns, focus.render.sampleRate, 0));
}

void requireWord (const char* option, const std::string& given, const std::vector<std::string_view>& allowed)
{
    if (std::find (allowed.begin(), allowed.end(), given) == allowed.end())
        throw InputError (option, "is " + inQuotes (given) + "; allowed: " + listed (allowed));
}

void writePages (OutputFolder& folder, const ReportPage& page, const RenderedFiles& files)
{
    if (files.hasReport)
        folder.write ("report.html", renderReport (page));

    for (const auto& format : files.figures)
        writeFigures (folder, page, format == "svg" ? VectorFormat::svg : VectorFormat::pdf);
}
} // namespace

void writeSamples (OutputFolder& folder, const RenderedFocus& focus, const std::string& format)
{
    const auto rate = focus.render.sampleRate;

    if (format == "csv")
        writeVoltagesCsv (folder, focus);
    else if (format == "mat")
        writeVoltagesMatlab (folder, focus);
    else if (format == "tfw")
        writeVoltagesTfw (folder, focus);
    else
        folder.write ("voltages.wav", encodeWave (outputVoltages (focus), focus.model.fullScaleVoltage, rate));

    if (! focus.probes.empty())
        folder.write ("probe.wav", encodeWave (focus.render.probeVelocities, probeFullScale, rate));

    writeProbes (folder, focus);
}

void writeRendered (const std::filesystem::path& path, const RenderedFocus& focus, const FocusOutcome& outcome,
                    const RenderedFiles& files)
{
    requireWord ("--format", files.format, { "wav", "csv", "mat", "tfw" });

    for (const auto& figure : files.figures)
        requireWord ("--figures", figure, { "svg", "pdf" });

    OutputFolder folder (path);
    writeSamples (folder, focus, files.format);
    writeFields (folder, focus);
    folder.write ("design.json", designToJson (focus.design, focus.known).dump (2) + "\n");
    folder.write ("summary.json", summaryToJson (focus, outcome).dump (2) + "\n");

    if (files.hasReport || ! files.figures.empty())
        writePages (folder, focusReport (focus, outcome), files);

    folder.commit();
}

std::vector<Field> fields (RenderRequest& request)
{
    constexpr double milliseconds = 1000;
    auto all = fields (request.design);
    all.front().value = FocusOrDesign { &request.design.focus, &request.made };
    append (all, { Field ("--probe",
                          NumberRows { "X or X,Y in mm, for example 24 or 24,10", 1, 2, true,
                                       [&request] (const auto& place) {
                                           request.probes.emplace_back (place[0] / milli,
                                                                        place.size() > 1 ? place[1] / milli : 0);
                                       } },
                          "Position of a velocity probe, mm (repeatable)")
                       .as ("probes_mm")
                       .written ("X,Y", ','),
                   Field ("--duration-ms", &request.duration, "Rendered duration from the trigger, ms")
                       .in (milliseconds)
                       .by ("until the surface has calmed down"),
                   Field ("--block-size", &request.blockSize, "Samples per block; does not affect the result")
                       .within (1, 8193) });
    return all;
}

RenderOptions renderOptions (const RenderRequest& request, const DesignedFocus& designed)
{
    RenderOptions options;
    options.playback = designed.playback;
    options.blockSize = request.blockSize;
    options.repetitions = designed.repetitions;
    options.threshold = findSkinThreshold (designed.thresholdFile.string());
    options.duration = request.duration;
    options.probes = request.probes;
    return options;
}

RenderedDesign render (const RenderRequest& request, const ShowProgress& show)
{
    const auto designed =
        request.made ? request.made : std::make_shared<const DesignedFocus> (design (request.design, show));
    auto focus = renderFocus (designed->made.wide, designed->made.design, renderOptions (request, *designed),
                              [&] (double share)
                              {
                                  if (show)
                                      show ("Rendering", share);
                              });
    auto outcome = evaluateOutcome (focus);
    return { designed, std::move (focus), std::move (outcome) };
}

namespace
{
constexpr auto columns = "x_mm,y_mm,wanted_mm_s,represented_mm_s,reached_mm_s\n";
constexpr int sectionPoints = 401;

/** What is wanted, represented and reached at one focus, N_p x 3, m/s. */
Eigen::MatrixXd fieldsAt (const RenderedFocus& focus, std::size_t moment)
{
    const auto& wanted = focus.design.moments[moment];
    Eigen::MatrixXd all (wanted.truncatedField.size(), 3);
    all << wanted.target.field, wanted.truncatedField, focus.moments[moment].field;
    return all;
}

void addRows (std::string& text, const std::string& first, const Eigen::MatrixX2d& places,
              const Eigen::MatrixXd& values)
{
    for (Eigen::Index i = 0; i < places.rows(); ++i)
        text += first
                + formatted ("%.9g,%.9g,%.9g,%.9g,%.9g\n", places (i, 0) * milli, places (i, 1) * milli,
                             values (i, 0) * milli, values (i, 1) * milli, values (i, 2) * milli);
}

/** Places on the surface along x (direction 0) or y (1) through a target. */
Eigen::MatrixX2d section (const Surface& surface, const Target& target, int direction)
{
    Eigen::MatrixX2d places (sectionPoints, 2);
    places.col (0).setConstant (target.x);
    places.col (1).setConstant (target.y);
    places.col (direction) = direction == 0
                                 ? Eigen::VectorXd::LinSpaced (sectionPoints, surface.xMinimum, surface.xMaximum)
                                 : Eigen::VectorXd::LinSpaced (sectionPoints, surface.yMinimum, surface.yMaximum);
    std::vector<Eigen::Index> on;

    for (Eigen::Index i = 0; i < places.rows(); ++i)
        if (liesOn (surface, places (i, 0), places (i, 1)))
            on.push_back (i);

    return places (on, Eigen::all);
}
} // namespace

void writeFields (OutputFolder& folder, const RenderedFocus& focus)
{
    const auto& surface = focus.model.surface;
    const auto on = pointsOn (surface);
    auto field = std::string ("focus,") + columns, sections = std::string ("focus,along,") + columns;

    for (std::size_t i = 0; i < focus.moments.size(); ++i)
    {
        const auto number = std::to_string (i + 1) + ",";
        const auto values = fieldsAt (focus, i);
        addRows (field, number, surface.points (on, Eigen::all), values (on, Eigen::all));

        if (surface.kind == SurfaceKind::plate)
            for (const auto direction : { 0, 1 })
            {
                const auto places = section (surface, focus.design.moments[i].targets.front(), direction);
                addRows (sections, number + (direction == 0 ? "x," : "y,"), places, fieldsAt (surface, values, places));
            }
    }

    folder.write ("field.csv", field);

    if (surface.kind == SurfaceKind::plate)
        folder.write ("section.csv", sections);
}

namespace
{
constexpr std::array moreIsBetter {
    "v_score",  "v_score_truncated",  "peak_ratio",    "peak_ratio_truncated", "contrast",
    "captured", "shortest_period_ms", "felt_level_dB", "felt_contrast_dB",     "event_contrast"
};

/** Letters, digits, points and hyphens; what else there is becomes a hyphen. */
std::string folderName (const std::string& name)
{
    auto plain = name;
    std::replace_if (
        plain.begin(), plain.end(),
        [] (char c) { return std::isalnum (static_cast<unsigned char> (c)) == 0 && c != '.' && c != '-' && c != '_'; },
        '-');
    return plain.empty() || plain.front() == '.' ? "focus" + plain : plain;
}

void add (std::vector<SeriesFocus>& series, std::set<std::string>& taken, const std::string& name,
          FocusDescription focus)
{
    auto folder = folderName (name);

    for (int i = 2; ! taken.insert (folder).second; ++i)
        folder = folderName (name) + "-" + std::to_string (i);

    series.push_back ({ folder, std::move (focus) });
}

std::vector<std::string> numberKeys (const std::vector<SeriesResult>& results)
{
    std::vector<std::string> keys;

    for (const auto& result : results)
        for (const auto& [key, value] : result.numbers)
            if (std::find (keys.begin(), keys.end(), key) == keys.end())
                keys.push_back (key);

    return keys;
}

using Numbers = std::vector<std::pair<std::string, double>>;

/** The numbers of an object and of objects in it, whose names stand before theirs: felt_contrast_dB. Lists are of
   single targets, ceramics and places. */
void addNumbers (Numbers& numbers, const nlohmann::ordered_json& object, const std::string& before)
{
    for (const auto& [key, value] : object.items())
        if (value.is_number())
            numbers.emplace_back (before + key, value.get<double>());
        else if (value.is_object())
            addNumbers (numbers, value, before + key + "_");
}

/** The weakest target's, or finger's that has a track. */
void addFeltLevel (Numbers& numbers, const nlohmann::ordered_json& summary)
{
    auto weakest = std::numeric_limits<double>::infinity();

    if (summary.contains ("felt"))
        for (const auto& target : summary["felt"]["targets"])
            weakest = std::min (weakest, target["level_dB"].get<double>());

    if (summary.contains ("fingers"))
        for (const auto& finger : summary["fingers"])
            if (finger.value ("has_track", false))
                weakest = std::min (weakest, finger["level_dB_SL"].get<double>());

    if (std::isfinite (weakest))
        numbers.emplace_back ("felt_level_dB", weakest);
}

/** Of all ceramics, in SI units. */
void addPower (Numbers& numbers, const nlohmann::ordered_json& summary)
{
    if (! summary.contains ("power") || ! summary["power"].contains ("per_focus"))
        return;

    const auto& once = summary["power"]["per_focus"];
    numbers.emplace_back ("energy_J", once["electrical_in_uJ"].get<double>() / micro);
    numbers.emplace_back ("peak_current_A", once["peak_current_mA"].get<double>() / milli);
    numbers.emplace_back ("peak_power_W", once["peak_power_mW"].get<double>() / milli);
}
} // namespace

std::vector<SeriesFocus> readSeries (const std::vector<std::string>& names, const std::string& placesFile,
                                     const std::vector<std::string>& assignments)
{
    std::vector<SeriesFocus> series;
    std::set<std::string> taken;

    for (const auto& name : names)
    {
        const auto focus = loadFocus (name, assignments);
        const auto title = focus.name.empty() ? "focus" : focus.name;

        if (placesFile.empty())
        {
            add (series, taken, title, focus);
            continue;
        }

        const auto places = readPointsFile (placesFile);

        for (Eigen::Index i = 0; i < places.rows(); ++i)
        {
            auto moved = focus;
            moved.targets.front().x = places (i, 0);
            moved.targets.front().y = places (i, 1);
            add (series, taken, title + "-" + std::to_string (i + 1), moved);
        }
    }

    return series;
}

std::vector<std::pair<std::string, double>> summaryNumbers (const nlohmann::ordered_json& summary)
{
    std::vector<std::pair<std::string, double>> numbers;

    if (summary.contains ("targets") && ! summary["targets"].empty())
    {
        const auto& place = summary["targets"][0]["wanted_place_mm"];
        numbers = { { "x_mm", place[0].get<double>() }, { "y_mm", place[1].get<double>() } };
    }

    addFeltLevel (numbers, summary);
    addPower (numbers, summary);
    addNumbers (numbers, summary, {});
    return numbers;
}

double seriesNumber (const SeriesResult& result, const std::string& key)
{
    const auto found = std::find_if (result.numbers.begin(), result.numbers.end(),
                                     [&] (const auto& each) { return each.first == key; });
    return found != result.numbers.end() ? found->second : std::nan ("");
}

std::vector<SeriesResult> ranked (std::vector<SeriesResult> results, const std::string& rankBy)
{
    const auto keys = numberKeys (results);

    if (! keys.empty() && std::find (keys.begin(), keys.end(), rankBy) == keys.end())
        throw InputError ("--rank-by",
                          "is " + inQuotes (rankBy) + "; allowed: " + listed ({ keys.begin(), keys.end() }));

    const auto sign = std::find (moreIsBetter.begin(), moreIsBetter.end(), rankBy) == moreIsBetter.end() ? 1 : -1;
    const auto place = [&] (const SeriesResult& result)
    {
        const auto value = seriesNumber (result, rankBy);
        return std::isnan (value) ? std::numeric_limits<double>::infinity() : sign * value;
    };
    std::stable_sort (results.begin(), results.end(),
                      [&] (const auto& a, const auto& b) { return place (a) < place (b); });
    return results;
}

std::string scoreTable (const std::vector<SeriesResult>& results)
{
    const auto keys = numberKeys (results);
    std::string text = "folder";

    for (const auto& key : keys)
        text += "," + key;

    text += ",error\n";

    for (const auto& result : results)
    {
        text += csvField (result.folder);

        for (const auto& key : keys)
        {
            const auto value = seriesNumber (result, key);
            text += std::isnan (value) ? "," : formatted (",%.9g", value);
        }

        text += "," + (result.error.empty() ? "" : csvField (result.error)) + "\n";
    }

    return text;
}
} // namespace antinode
