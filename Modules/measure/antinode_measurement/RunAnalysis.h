#pragma once

#include "EstimatedResponses.h"
#include "Excitation.h"
#include "RunRecording.h"
#include "WelchEstimate.h"

namespace antinode
{
/** Options of the analysis of runs. */
struct RunAnalysisSettings
{
    ResponseEstimator estimator = ResponseEstimator::h1; ///< Of noise.
    double latency = 0; ///< Latency of the sensors without a sync channel, samples, at least 0.
};

/** One ceramic's responses and how late its recording was. */
struct RunResponses
{
    EstimatedResponses responses; ///< (m/s)/V on the excitation's lines.
    double latency = 0;           ///< Samples, taken out of the responses.
};

/** Responses from a run: finds its latency, cuts out the evaluated samples, applies the estimator of the excitation,
   and rotates the phases back by what the cut left of the latency.

    With a measured reference the responses relate to it; the latency, which both share, then serves only to cut.
    @throws InputError  where the recording is too short, holds numbers that are not finite, or not the excitation
    [worker] Docs/Theory.md, section 8.9. */
RunResponses analyseRun (const Excitation&, Eigen::Index ceramic, const RunRecording&, const RunAnalysisSettings& = {});
} // namespace antinode
