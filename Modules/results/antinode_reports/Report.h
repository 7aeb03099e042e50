#pragma once

#include "Chart.h"
#include "ChartFile.h"

#include <antinode_text/OutputFolder.h>

#include <string>
#include <vector>

namespace antinode
{
/** How wide a picture in a report is where it does not say, pixels at scale 1. */
inline constexpr int reportFigureWidth = 900;

/** A picture in a report. */
struct ReportFigure
{
    std::string caption;         ///< A sentence or two below the picture.
    std::string alternativeText; ///< Text alternative of the picture; the caption if empty.
    Chart chart;
    int width = reportFigureWidth, height = 360; ///< Pixels at scale 1.
    float scale = 2;                             ///< Of the picture: 2 for text and lines, 1 for many coloured maps.
};

/** A table: cells that are numbers are aligned at the right. */
struct ReportTable
{
    std::string caption;
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;
};

/** Whether the cells of a column that are not empty are numbers. [any] */
bool isNumberColumn (const ReportTable&, std::size_t column);

/** A part of a page: text, then figures, then tables. */
struct ReportSection
{
    std::string heading;
    std::vector<std::string> paragraphs;
    std::vector<ReportFigure> figures;
    std::vector<ReportTable> tables;
};

/** A key number of the report. */
struct ReportScore
{
    std::string name;
    std::string value;    ///< With its unit.
    std::string sentence; ///< Its meaning.
};

/** Another page in the same folder. */
struct ReportLink
{
    std::string text;
    std::string file; ///< A file in the folder of this page.
};

/** A whole page. All text is plain UTF-8: whatever it contains is shown as it is. */
struct ReportPage
{
    std::string title, subtitle;
    std::vector<ReportLink> links;
    std::vector<ReportScore> scores;
    std::vector<std::string> warnings;
    std::vector<ReportSection> sections;
    std::string footer;
};

/** A page as one self-contained HTML file: no network, no scripts, light and dark pictures inside. The same bytes for
   the same page on every run. Draws on as many threads as the machine has.
    @throws InputError  what renderPng() throws
    [worker] */
std::string renderReport (const ReportPage&);

/** The same page for print, without links: a PDF of A4 pages, black on white. Text stays text. The same bytes for the
    same page on every run. @throws InputError  what draw() throws [worker] */
std::string renderReportPdf (const ReportPage&);

/** A figure of a report and the name of its file without the ending: its section and its place in it, as in
    "figure-voltages-1". */
struct NamedFigure
{
    std::string name;
    const ReportFigure* figure = nullptr;
};

/** All figures of a page, which outlives them. [any] */
std::vector<NamedFigure> namedFigures (const ReportPage&);

/** Writes all figures of a page for print, on as many threads as the machine has.
    @throws InputError  what renderVector() and OutputFolder throw
    [worker] */
void writeFigures (OutputFolder&, const ReportPage&, VectorFormat);
} // namespace antinode
