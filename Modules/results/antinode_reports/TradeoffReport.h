#pragma once

#include "Report.h"

#include <antinode_focus/Tradeoff.h>
#include <antinode_render/FeltTradeoff.h>

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

/** The keys of tradeoff.json of a focus with less felt elsewhere. Docs/FileFormats.md. [any] */
nlohmann::ordered_json feltTradeoffToJson (const FeltTradeoff&, const std::string& focus, const std::string& device);

/** The same points as a table with one line per point. [any] */
std::string feltTradeoffToCsv (const FeltTradeoff&);

/** The table as text for the terminal. [any] */
std::string feltTradeoffToText (const FeltTradeoff&);

/** The page: the curve of voltage against felt contrast, and the table. [any] */
ReportPage feltTradeoffReport (const FeltTradeoff&, const std::string& focus, const std::string& device);
} // namespace antinode
