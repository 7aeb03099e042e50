#pragma once

#include "Design.h"
#include "DrawnDevices.h"

#include <antinode_base/Progress.h>
#include <antinode_focus/Tolerance.h>
#include <antinode_text/OutputFolder.h>

#include <filesystem>
#include <string>
#include <vector>

namespace antinode
{
inline constexpr TaskText toleranceText { "design --tolerance", "Plays a design on devices that differ from the model",
                                          "Docs/Theory.md, section 7.4" };

/** A design, and the devices that it is played on. */
struct ToleranceRequest
{
    FocusRequest design;
    std::shared_ptr<const DesignedFocus> made; ///< Played as it is, in place of a new design.
    DrawnDevices devices;         ///< Usually as the focus is robust against, else by the origin of the modes.
    std::filesystem::path folder; ///< Where the draws of long studies are kept while they are computed, so that they
                                  ///< resume after a kill; empty: nowhere.
};

/** [any] */
std::vector<Field> fields (ToleranceRequest&);

/** What designs do on devices that differ from the model; the last one is the one that was asked about. */
struct DesignOnDevices
{
    std::shared_ptr<const DesignedFocus> design;
    ModalModel model;
    std::vector<DesignTolerance> tolerances;

    const std::string& focus() const { return design->made.design.description.name; }
};

/** The design on devices drawn around the model; for a robust design also the nominal one, on the same devices.
    @throws InputError  as designFocus and resumableTolerance [worker] */
DesignOnDevices tolerance (const ToleranceRequest&, const ShowProgress&);

/** Adds tolerance.json and tolerance.html to the files of a folder.
    [worker] Docs/FileFormats.md. */
void writeTolerances (OutputFolder&, const DesignOnDevices&);

/** The percentiles as a table, and the largest causes of error as sentences: text of several lines. [any] */
std::string tolerancesInWords (const DesignOnDevices&);
} // namespace antinode
