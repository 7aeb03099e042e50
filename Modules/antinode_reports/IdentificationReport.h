#pragma once

#include "Report.h"

#include <antinode_identification/Comparison.h>
#include <antinode_model/ModalModel.h>

#include <optional>

namespace antinode
{
/** All that an identification has led to. */
struct IdentificationResult
{
    FrequencyResponses measured;
    std::vector<std::string> pointNames;
    IdentifiedModes modes;
    ModalModel model;                         ///< The device that these modes make.
    std::vector<std::string> remarks;         ///< What was assumed when files were read.
    std::optional<ModeComparison> comparison; ///< With a computed device.
    std::optional<ModalModel> computed;
};

/** What there is to doubt: of the files, of the whole, of every mode, in sentences. [any] */
std::vector<std::string> doubtsOf (const IdentificationResult&);

/** The report of an identification: stabilisation diagram, measured and synthesised responses, shapes, who drives what, MAC, the modes in
    numbers with their standard deviations, the comparison with a computed device, and what is doubtful and why. [worker] */
ReportPage identificationReport (const IdentificationResult&);
} // namespace antinode
