#pragma once

#include "Report.h"

#include <antinode_identification/Comparison.h>
#include <antinode_model/ModalModel.h>
#include <antinode_structure/DeviceDescription.h>

#include <optional>

namespace antinode
{
/** The results of an identification. */
struct IdentificationResult
{
    FrequencyResponses measured;
    std::vector<std::string> pointNames;
    IdentifiedModes modes;
    ModalModel model;                           ///< The device with these modes.
    std::vector<std::string> remarks;           ///< What was assumed when files were read.
    std::optional<ModeComparison> comparison;   ///< With a computed device.
    std::optional<ModalModel> computed;         ///< What was measured, as it is drawn: compared with, or the outline's.
    std::optional<DeviceDescription> described; ///< What was computed.
};

/** Warnings about the files, the whole identification and every mode, as sentences. [any] */
std::vector<std::string> collectWarnings (const IdentificationResult&);

/** The report of an identification: stabilisation diagram, measured and synthesised responses in the band, shapes,
   participation, MAC, the modes in numbers with their standard deviations and warnings, the comparison with a computed
   device.
    @param diagramName  the file of identificationDiagram() in the same folder; none if empty
    [worker] */
ReportPage identificationReport (const IdentificationResult&, const std::string& diagramName);
} // namespace antinode
