#pragma once

#include "Chart.h"
#include "Report.h"

#include <antinode_identification/Comparison.h>
#include <antinode_identification/IdentifiedModes.h>
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

/** The stabilisation diagram: poles of all model orders over frequency, those that belong to a mode in a colour of
   their own, the modes that were kept as vertical lines, and the mean magnitude of the measured responses as a curve
   without a scale. [any] */
LineChart stabilisationChart (const IdentifiedModes&, const FrequencyResponses& measured);

/** Magnitude and phase of one measured response, and of the same as the modes give it. Sizes of both agree. The phases
   are those without the delay; that of the measured response has gaps where its noise hides it.
    @param delay  common to both, s
    [any] */
ChartGrid responseChart (const FrequencyResponses& measured, const FrequencyResponses& synthesised, Eigen::Index point,
                         Eigen::Index reference, double delay);

/** A matrix of the modal assurance criterion, 0 to 1: a row and a column a mode, which are named by their numbers
   from 1.
    @param rowLabel, columnLabel  of the axes [any] */
HeatMap assuranceChart (const Eigen::MatrixXd& assurance, const std::string& rowLabel, const std::string& columnLabel);
} // namespace antinode
