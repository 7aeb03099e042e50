#include "RenderFiles.h"

#include "FieldFiles.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/DesignFile.h>
#include <antinode_render/Summary.h>
#include <antinode_reports/FigureFiles.h>
#include <antinode_reports/FocusReport.h>
#include <antinode_text/MatlabWriter.h>
#include <antinode_text/TfwFile.h>
#include <antinode_text/WaveFile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>

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
} // namespace antinode
