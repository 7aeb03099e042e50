#pragma once

#include <antinode_engine/LagFilters.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace antinode
{
/** What undoing lags costs, in one line. [any] */
std::string lagsInWords (const UndoneLags&);

/** As summary.json has it. [any] Docs/FileFormats.md. */
nlohmann::ordered_json lagJson (const UndoneLags&);
} // namespace antinode
