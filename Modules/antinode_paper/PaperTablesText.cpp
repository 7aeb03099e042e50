#include "PaperResults.h"
#include "PaperTables.h"

#include <antinode_base/NumberText.h>
#include <antinode_focus/DesignFocus.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace antinode
{
namespace
{
const std::vector<std::string> placeHeader { "shape", "P1", "P2", "P3", "P4", "P5" };

/** A table with one row per shape and one column per position. */
template <typename CellText>
ReportTable placeTable (const std::string& caption, const std::vector<PaperCell>& cells, CellText&& text)
{
    ReportTable table { caption, placeHeader, {} };

    for (std::size_t row = 0; row < paperTables.size(); ++row)
    {
        table.rows.push_back ({ std::string (paperTables[row].name) });

        for (std::size_t place = 0; place < paperPlaces; ++place)
            table.rows.back().push_back (text (cells[row * paperPlaces + place], paperTables[row], place));
    }

    return table;
}

ReportTable capturedTable (const std::vector<PaperCell>& cells)
{
    return placeTable (
        "Table C.1, captured sqrt(S/K): ours / print", cells,
        [] (const PaperCell& cell, const PaperRow& row, std::size_t place)
        { return formatted ("%.4f", cell.exact.design.captured) + " / " + formatted ("%.4f", row.captured[place]); });
}

ReportTable modesNeededTable (const std::vector<PaperCell>& cells)
{
    return placeTable ("Modes needed, by energy, to reach Table C.1: needed / the print's count", cells,
                       [] (const PaperCell& cell, const PaperRow& row, std::size_t)
                       {
                           return (cell.modesNeeded > 0 ? std::to_string (cell.modesNeeded) : std::string ("none"))
                                  + " / " + std::to_string (row.modes);
                       });
}

ReportTable scoreTable (const std::vector<PaperCell>& cells)
{
    return placeTable ("v-score against the truncated field: rows (29) / exact", cells,
                       [] (const PaperCell& cell, const PaperRow&, std::size_t)
                       {
                           return formatted ("%.5f", cell.paper.truncatedScore.vScore) + " / "
                                  + formatted ("%.6f", cell.exact.truncatedScore.vScore);
                       });
}

ReportTable errorTable (const std::vector<PaperCell>& cells)
{
    return placeTable ("Field error against the truncated field: rows (29) / exact", cells,
                       [] (const PaperCell& cell, const PaperRow&, std::size_t)
                       {
                           return formatted ("%.5f", cell.paper.truncatedScore.fieldError) + " / "
                                  + formatted ("%.5f", cell.exact.truncatedScore.fieldError);
                       });
}

ReportTable peakTable (const std::vector<PaperCell>& cells)
{
    return placeTable ("Peak voltage, V: exact / minimum norm of (29)", cells,
                       [] (const PaperCell& cell, const PaperRow&, std::size_t)
                       {
                           return formatted ("%.2f", peakVoltage (cell.exact.design)) + " / "
                                  + formatted ("%.2f", cell.drivePeaks[0].offsetFree);
                       });
}

ReportTable driveTable (const std::vector<PaperCell>& cells, std::size_t index)
{
    const auto growth = paperGrowths[index] ? inWords (*paperGrowths[index]) : std::string ("chosen");
    return placeTable ("Peak voltage of the minimum norm of (29), V, growth " + growth
                           + ": paper's drive / offset-free (ratio)",
                       cells,
                       [index] (const PaperCell& cell, const PaperRow&, std::size_t)
                       {
                           const auto& peaks = cell.drivePeaks[index];
                           return formatted ("%.1f", peaks.paper) + " / " + formatted ("%.1f", peaks.offsetFree) + " ("
                                  + formatted ("%.2f", peaks.paper / peaks.offsetFree) + ")";
                       });
}

ReportTable detunedTable (const std::vector<PaperCell>& cells, std::size_t level)
{
    const auto& detuning = paperDetuning[level];
    const auto caption = "Table C.2, v-score on detuned plates (" + inWords (100 * detuning.frequency)
                         + " % frequency, " + inWords (100 * detuning.damping) + " % damping, "
                         + inWords (100 * detuning.participation) + " % participation; median of "
                         + std::to_string (paperDraws) + " draws): ours / measured";
    return placeTable (caption, cells,
                       [level] (const PaperCell& cell, const PaperRow& row, std::size_t place)
                       {
                           const auto measured =
                               row.vScore ? formatted ("%.4f", (*row.vScore)[place]) : std::string ("-");
                           return formatted ("%.4f", cell.detunedVScore[level]) + " / " + measured;
                       });
}

std::string outcomeText (const TwoModeCase& one)
{
    if (! one.result)
        return "infeasible: needs at least " + inWords (one.minimumPeakVoltage) + " V; the limit allows "
               + inWords (one.reachableVelocity * 1000) + " mm/s";

    if (one.peakVoltage > one.limit)
        return "needs " + inWords (one.peakVoltage) + " V and is clipped";

    return "feasible, peak " + inWords (one.peakVoltage) + " V";
}

ReportTable twoModeTable (const TwoModeStudy& study)
{
    ReportTable table { "Two modes (" + inWords (study.frequencies[0]) + " and " + inWords (study.frequencies[1])
                            + " Hz, 20 mm/s each at the centre) with " + study.ceramics[0] + " and "
                            + study.ceramics[1],
                        { "drive", "limit", "allocation", "outcome", "field error" },
                        {} };

    for (const auto& one : study.cases)
        table.rows.push_back ({ one.drive == DriveKind::paper ? "paper's" : "offset-free", inWords (one.limit) + " V",
                                one.isAllocated ? "rows (29) within the limit" : "one ceramic per mode",
                                outcomeText (one),
                                one.result ? formatted ("%.4f", one.result->truncatedScore.fieldError) : "-" });

    return table;
}

/** Characters, not bytes. */
std::size_t countCharacters (const std::string& text)
{
    return static_cast<std::size_t> (
        std::count_if (text.begin(), text.end(), [] (char c) { return (c & 0xC0) != 0x80; }));
}
} // namespace

std::vector<ReportTable> makePaperTables (const std::vector<PaperCell>& cells, const TwoModeStudy& study)
{
    std::vector<ReportTable> tables { capturedTable (cells), modesNeededTable (cells), scoreTable (cells),
                                      errorTable (cells), peakTable (cells) };

    for (std::size_t index = 0; index < paperGrowths.size(); ++index)
        tables.push_back (driveTable (cells, index));

    for (std::size_t level = 0; level < paperDetuning.size(); ++level)
        tables.push_back (detunedTable (cells, level));

    tables.push_back (twoModeTable (study));
    return tables;
}

std::string plainText (const ReportTable& table)
{
    std::vector<std::size_t> widths;

    for (std::size_t column = 0; column < table.header.size(); ++column)
    {
        widths.push_back (countCharacters (table.header[column]));

        for (const auto& row : table.rows)
            widths[column] = std::max (widths[column], countCharacters (row[column]));
    }

    auto text = table.caption + "\n";
    const auto append = [&] (const std::vector<std::string>& row)
    {
        text += " ";

        for (std::size_t column = 0; column < row.size(); ++column)
            text += " " + row[column] + std::string (widths[column] - countCharacters (row[column]) + 1, ' ');

        text.erase (text.find_last_not_of (' ') + 1);
        text += "\n";
    };
    append (table.header);

    for (const auto& row : table.rows)
        append (row);

    return text;
}
} // namespace antinode
