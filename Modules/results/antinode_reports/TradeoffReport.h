#pragma once

#include "Report.h"

#include <antinode_focus/Tradeoff.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace antinode
{
/** The keys of tradeoff.json. Docs/FileFormats.md. [any] */
nlohmann::ordered_json tradeoffToJson (const Tradeoff&, const std::string& focus, const std::string& device);

/** The same points as a table with one line per point. [any] */
std::string tradeoffToCsv (const Tradeoff&);

/** The table as text for the terminal. [any] */
std::string tradeoffToText (const Tradeoff&);

/** The page: the picture of voltage against time in motion, and the table. [any] */
ReportPage tradeoffReport (const Tradeoff&, const std::string& focus, const std::string& device);
} // namespace antinode
