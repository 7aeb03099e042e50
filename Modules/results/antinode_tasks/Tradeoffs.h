#pragma once

#include "Design.h"

#include <antinode_focus/Tradeoff.h>
#include <antinode_render/FeltTradeoff.h>
#include <antinode_reports/Report.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <variant>

namespace antinode
{
inline constexpr TaskText tradeoffText { "design --tradeoff", "Compares designs of a focus by all methods and growths",
                                         "Docs/Theory.md, sections 4.10 and 4.14" };

/** Designs of one focus that are compared: by method and growth, or, of a focus with `felt`, by its weight. */
struct DesignTradeoff
{
    std::string focus, device;
    std::variant<Tradeoff, FeltTradeoff> found;

    /** How many designs there are. */
    std::size_t designs() const;

    /** How many there are when all are finished. */
    std::size_t planned() const;
};

/** Is given all designs so far, and the share of the work that is done, 0 to 1. */
using ShowTradeoff = std::function<void (const DesignTradeoff& soFar, double share)>;

/** The designs of a focus by all methods and growths, or by all weights of the felt level elsewhere.
    @param show  called after each design, from one thread at a time; may be empty
    @throws InputError  as sweepTradeoff and sweepFeltWeights, and for what cannot be solved; Cancelled as checkWatch()
    [worker] Docs/Theory.md, sections 4.10 and 4.14. */
DesignTradeoff designTradeoff (const FocusRequest&, const ShowTradeoff& show);

/** The same with progress only. [worker] */
DesignTradeoff tradeoff (const FocusRequest&, const ShowProgress&);

/** tradeoff.json. [worker] Docs/FileFormats.md. */
nlohmann::ordered_json tradeoffDocument (const DesignTradeoff&);

/** tradeoff.html: curves and the table. [worker] */
ReportPage tradeoffPage (const DesignTradeoff&);

/** The table for the terminal. [any] */
std::string tradeoffInWords (const DesignTradeoff&);

/** Writes tradeoff.json, tradeoff.csv and tradeoff.html.
    @throws InputError  when the folder cannot be written
    [worker] Docs/FileFormats.md. */
void writeTradeoff (const std::filesystem::path& folder, const DesignTradeoff&);
} // namespace antinode
