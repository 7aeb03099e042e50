#include "FollowFiles.h"

#include <antinode_base/NumberText.h>
#include <antinode_documents/ChangedDevice.h>
#include <antinode_focus/SpillOver.h>
#include <antinode_reports/Report.h>
#include <antinode_text/CsvText.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

namespace antinode
{
namespace
{
constexpr double inPpm = 1e6, inPercents = 100;
constexpr Eigen::Index mostCurves = 6; // of single modes in the picture

/** A line per moment: what all modes share, then each mode's change and its deviation. */
std::string driftTable (const DriftTrace& trace, Eigen::Index modes)
{
    constexpr int digits = 9;
    std::string text = "time_s,state,unexplained_percent,jump_percent,common_ppm";

    for (Eigen::Index k = 1; k <= modes; ++k)
        text += ",mode_" + std::to_string (k) + "_ppm,mode_" + std::to_string (k) + "_deviation_ppm";

    text += "\n";
    const auto add = [&] (double value)
    {
        text += ',';
        appendCsvNumber (text, value, digits);
    };

    for (const auto& moment : trace.moments)
    {
        appendCsvNumber (text, moment.time, digits);
        text += std::string (",") + driftStateWord (moment.state);
        add (inPercents * moment.unexplained);
        add (inPercents * moment.jump);
        add (inPpm * moment.common);

        for (Eigen::Index k = 0; k < modes; ++k)
        {
            add (inPpm * moment.frequencies[k]);
            add (inPpm * moment.deviations[k]);
        }

        text += "\n";
    }

    return text;
}

/** How one of the numbers of moments changes; gaps where nothing was heard. */
template <typename Value>
Series curve (const DriftTrace& trace, const std::string& name, const Value& value)
{
    const auto count = static_cast<Eigen::Index> (trace.moments.size());
    Series series;
    series.name = name;
    series.x.resize (count);
    series.y.resize (count);
    series.points = count < 100;

    for (Eigen::Index i = 0; i < count; ++i)
    {
        const auto& moment = trace.moments[static_cast<std::size_t> (i)];
        series.x[i] = moment.time;
        series.y[i] =
            moment.state == DriftState::following ? inPpm * value (moment) : std::numeric_limits<double>::quiet_NaN();
    }

    return series;
}

LineChart driftChart (const ModalModel& nominal, Eigen::Index known, const DriftTrace& trace)
{
    LineChart chart;
    chart.xLabel = "time (s)";
    chart.yLabel = "change of frequency (ppm)";
    chart.series.push_back (curve (trace, "common", [] (const DriftMoment& moment) { return moment.common; }));

    // The modes that are known best, from the lowest up.
    std::vector<Eigen::Index> modes (static_cast<std::size_t> (known));
    std::iota (modes.begin(), modes.end(), Eigen::Index { 0 });
    const auto& deviations = trace.moments.back().deviations;
    std::stable_sort (modes.begin(), modes.end(),
                      [&] (Eigen::Index a, Eigen::Index b) { return deviations[a] < deviations[b]; });
    modes.resize (std::min (modes.size(), static_cast<std::size_t> (mostCurves)));
    std::sort (modes.begin(), modes.end());

    for (const auto k : modes)
    {
        auto series = curve (trace, inWords (nominal.frequencyHz (k)) + " Hz",
                             [k] (const DriftMoment& moment) { return moment.frequencies[k]; });
        series.style = LineStyle::dashed;
        chart.series.push_back (std::move (series));
    }

    return chart;
}
} // namespace

const char* driftStateWord (DriftState state)
{
    return state == DriftState::following ? "following" : state == DriftState::silent ? "silent" : "lost";
}

ReportPage driftReport (const FollowedDevice& followed)
{
    const auto& [device, nominal, known, trace] = followed;
    ReportSection section;
    section.heading = "Frequencies";
    section.figures.push_back ({ "Change of all frequencies, and of the best observed modes, from the device. Gaps: "
                                 "nothing was played, or the signals were not explained.",
                                 {},
                                 driftChart (nominal, known, trace) });
    ReportTable table { "Windows that were not followed, and jumps",
                        { "time (s)", "state", "unexplained (%)", "jump (%)", "" },
                        {} };

    for (const auto& moment : trace.moments)
        if (moment.state == DriftState::lost || moment.jump != 0)
            table.rows.push_back ({ inWords (moment.time), driftStateWord (moment.state),
                                    inWords (inPercents * moment.unexplained), inWords (inPercents * moment.jump),
                                    moment.reason });

    if (! table.rows.empty())
        section.tables.push_back (std::move (table));

    ReportPage page;
    page.title = "Drift of " + nominal.name;
    page.sections = { std::move (section) };
    page.links = { { "drift.csv", "drift.csv" }, { "device.json", "device.json" } };
    page.footer = "Antinode " ANTINODE_VERSION ".";
    return page;
}

nlohmann::ordered_json driftToJson (const DriftTrace& trace)
{
    const auto count = [&] (DriftState state)
    {
        return std::count_if (trace.moments.begin(), trace.moments.end(),
                              [state] (const DriftMoment& moment) { return moment.state == state; });
    };
    const auto& last = trace.moments.back();
    return { { "schema", "antinode.drift/1" },
             { "windows_followed", count (DriftState::following) },
             { "windows_silent", count (DriftState::silent) },
             { "windows_lost", count (DriftState::lost) },
             { "common_ppm", inPpm * last.common },
             { "last_state", driftStateWord (last.state) },
             { "last_reason", last.reason } };
}

std::string driftedDeviceText (const FollowedDevice& followed)
{
    const auto& [device, nominal, known, trace] = followed;
    const auto drifted = driftedModel (nominal, driftLayout (nominal, 1), trace.estimate.values);
    return changedDeviceText (device, firstModes (nominal, known), firstModes (drifted, known),
                              "Followed while it was played");
}

void writeDrift (const std::filesystem::path& path, const FollowedDevice& followed)
{
    OutputFolder folder (path);
    folder.write ("drift.csv", driftTable (followed.trace, followed.known));
    folder.write ("device.json", driftedDeviceText (followed));
    folder.write ("summary.json", driftToJson (followed.trace).dump (2) + "\n");
    folder.write ("report.html", renderReport (driftReport (followed)));
    folder.commit();
}
} // namespace antinode
