#pragma once

#include "PaperFigures.h"

#include <antinode_reports/Report.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace antinode
{
/** The keys of paper.json: our numbers and the printed ones. Docs/FileFormats.md. [any] */
nlohmann::ordered_json paperJson (const std::vector<PaperCell>&, const TwoModeStudy&, const std::vector<PaperFigure>&);

/** The same as tables, for the terminal and the report: captured, v-scores, field errors, voltages, detuned plates, two
    modes. [any] */
std::vector<ReportTable> makePaperTables (const std::vector<PaperCell>&, const TwoModeStudy&);

/** A table as fixed-width text. [any] */
std::string plainText (const ReportTable&);

/** The report of the reproduction. [any] */
ReportPage paperReport (const ModalModel&, const std::vector<ReportTable>&, std::vector<PaperFigure>);
} // namespace antinode
