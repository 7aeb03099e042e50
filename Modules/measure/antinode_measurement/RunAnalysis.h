#pragma once

#include "EstimatedResponses.h"
#include "Excitation.h"

#include <Eigen/Core>

namespace antinode
{
/** The recording of one ceramic's run, from its first sample on. N_s samples, at least those of the signal. */
struct RunRecording
{
    Eigen::MatrixXd sensors;   ///< N x N_s: velocities, m/s.
    Eigen::VectorXd sync;      ///< N_s, any unit; empty if the sync channel was not recorded.
    Eigen::VectorXd reference; ///< N_s: the ceramic's voltage as it was measured, V; empty: as played.
};

/** The scale of recorded samples. */
struct SensorScale
{
    double sensitivity = 0;    ///< mm/s per V; 0: unknown.
    double inputFullScale = 1; ///< Input voltage of a recorded sample of 1, V.

    /** The velocity of a recorded sample of 1, m/s. */
    double fullScaleVelocity() const { return inputFullScale * sensitivity / 1000; }
};

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

/** The latency of a recording of the sync channel in samples, to 0.01 samples or better: the lag of the largest
    correlation, then the slope of the cross-spectrum's phase, every line weighted by its power and its frequency's
   square.
    @param sync  a run's recording of the sync channel, any gain or sign but 0
    @return      samples, at least 0
    @throws InputError  where the excitation is not in it, or so late that its end is missing
    [worker] Docs/Theory.md, section 8.9. */
double estimateLatency (const Excitation&, const Eigen::VectorXd& sync);
} // namespace antinode
