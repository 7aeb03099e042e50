#pragma once

#include "VectorFile.h"

#include "Report.h"
#include <antinode_text/OutputFolder.h>

#include <string>
#include <vector>

namespace antinode
{
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
