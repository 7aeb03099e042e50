#pragma once

#include "Progress.h"

#include <antinode_focus/DesignTolerance.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <vector>

namespace antinode
{
/** What `antinode design --tolerance` asks for. */
struct ToleranceCommandOptions
{
    bool isWanted = false;
    int draws = 200;
    int seed = 1;
    std::optional<double> frequency, damping, participation, drift; ///< %
};

/** Adds them to a sub-command. The struct must live as long as the app. */
void addToleranceOptions (CLI::App&, ToleranceCommandOptions&);

/** The design on devices drawn around the model; beside a robust one what it would be without, on the same devices. Spreads that are not
    asked for are those that the focus is robust against, else the usual ones.
    @throws InputError  for a spread that is not allowed, and as designFocus. [worker] */
std::vector<DesignTolerance> designTolerances (const ModalModel&, const FocusDesign&, const ToleranceCommandOptions&,
                                               Progress&);

/** The percentiles as a table, and the sentences of what hurts most, as text of several lines. [any] */
std::string tolerancesInWords (const ModalModel&, const std::vector<DesignTolerance>&);
} // namespace antinode
