#pragma once

#include "RunAnalysis.h"

#include <antinode_identification/FrequencyResponses.h>

#include <string>
#include <vector>

namespace antinode
{
/** The results of all runs at all points. N_f lines, N_p points, N_b ceramics; NaN where nothing was measured yet. */
struct SurfaceMeasurement
{
    FrequencyResponses responses;
    std::vector<Eigen::MatrixXd> coherence; ///< N_b of N_f x N_p.
    std::vector<std::vector<NonlinearDistortion>>
        distortion;            ///< N_b of N_p; of all 0 where the excitation does not show it.
    Eigen::MatrixXd latencies; ///< N_b x N_p: samples.
};

/** An empty measurement.
    @param ceramics  N_b names
    @param points    N_p x 2, m
    [worker] */
SurfaceMeasurement unmeasured (const Excitation&, const std::vector<std::string>& ceramics,
                               const Eigen::MatrixX2d& points);

/** Stores a ceramic's run, measured by sensors at consecutive points from a first one on. [worker] */
void place (SurfaceMeasurement&, Eigen::Index ceramic, Eigen::Index firstPoint, const RunResponses&);

/** Warnings about the quality of a measurement, as sentences: points and ceramics with weak responses, latencies that
    wander, distortion; a list that is empty if all is well. [worker] Docs/Theory.md, section 8.9. */
std::vector<std::string> collectWarnings (const SurfaceMeasurement&);

/** The mean coherence over the lines, weighted by the responses' power: N_p x N_b, not a number where it is not known.
    [worker] */
Eigen::MatrixXd meanCoherence (const SurfaceMeasurement&);
} // namespace antinode
