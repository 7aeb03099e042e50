#pragma once

#include "FocusOutcome.h"

#include <nlohmann/json_fwd.hpp>

namespace antinode
{
/** The keys of summary.json. Docs/FileFormats.md. [any] */
nlohmann::ordered_json summaryToJson (const RenderedFocus&, const FocusOutcome&);
} // namespace antinode
