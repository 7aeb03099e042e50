#pragma once

#include <antinode_base/ShowProgress.h>
#include <antinode_focus/DesignTolerance.h>
#include <antinode_text/OutputFolder.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The options of `antinode design --tolerance`. */
struct ToleranceCommandOptions
{
    bool isWanted = false;
    int draws = 200;
    int seed = 1;
    std::optional<double> frequency, damping, participation, drift; ///< %
};

/** Adds them to a sub-command. The struct must live as long as the app. */
void addToleranceOptions (CLI::App&, ToleranceCommandOptions&);

/** The design on devices drawn around the model; for a robust design also the nominal one, on the same devices. Spreads
   that are not requested are those that the focus is robust against, else the usual ones.
    @param folder    where the draws of long studies are kept while they are computed, so that they resume after a kill;
                     empty: nowhere
    @param progress  may be empty
    @throws InputError  for a spread that is not allowed, and as designFocus and resumableTolerance. [worker] */
std::vector<DesignTolerance> designTolerances (const ModalModel&, const FocusDesign&, const ToleranceCommandOptions&,
                                               const std::filesystem::path& folder, const ShowProgress& progress);

/** Adds tolerance.json and tolerance.html to the files of a folder.
    @param focus  its name
    [worker] Docs/FileFormats.md. */
void writeTolerances (OutputFolder&, const ModalModel&, const std::string& focus, const std::vector<DesignTolerance>&);

/** The percentiles as a table, and the largest causes of error as sentences: text of several lines. [any] */
std::string tolerancesInWords (const ModalModel&, const std::vector<DesignTolerance>&);
} // namespace antinode
