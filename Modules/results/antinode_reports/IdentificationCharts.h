#pragma once

#include "Chart.h"

#include <antinode_identification/IdentifiedModes.h>

namespace antinode
{
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
