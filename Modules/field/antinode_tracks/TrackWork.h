#pragma once

#include "TrackDesign.h"
#include "WindowedResponses.h"

#include <Eigen/Core>

#include <optional>

namespace antinode
{
/** The samples of a design: how many, and how many of the played ones each is. */
struct TrackSpan
{
    Eigen::Index factor = 1;
    double rate = 0;         // Hz
    Eigen::Index lead = 0;   // samples of voltage before the trigger
    Eigen::Index wanted = 0; // samples from the trigger to the end of the last track
    Eigen::Index window = 0; // samples of voltage
    Eigen::Index length = 0; // of the transforms
};

/** A design while it is made. */
struct TrackWork
{
    TrackSpan span;
    WindowedResponses responses;
    Eigen::MatrixXd wanted; // length x points
    Eigen::VectorXd limits, slews;
    double sampleRate = 0; // Hz, of what is played
};

/** The median over a band, and all places of what moves, of the smallest singular value of responses, squared, m^2/V^2:
    what voltages can well bring. @param nodes  as those of WindowedResponses [worker] */
double smallestResponse (const PointResponses& nodes, const MovingPoints&, TrackBand band);

/** The design at its own rate. @throws InputError  as designTracks [worker] */
TrackWork trackWork (const ModalModel&, const WaveformsDescription&, const TrackSettings&);

/** The same design at a multiple of its rate, the one that is played if that is at most eight times as high; none if
    that takes more memory than designs may.
    @param coarse  as trackWork gives it
    [worker] */
std::optional<TrackWork> finerWork (const ModalModel&, const WaveformsDescription&, const TrackWork& coarse);

/** Signals at a multiple of their rate: zeros behind their lines. @param signals  N_s x any number [worker] */
Eigen::MatrixXd finer (const Eigen::MatrixXd& signals, Eigen::Index factor);

/** Whether a waveform is nearer to its slew rates than to its peaks. @param played  as for timesLimits [worker] */
bool isSteep (const TrackWork&, const Eigen::MatrixXd& played);

/** How many times its limits a waveform is: the largest of peak and slew over all ceramics.
    @param played  samples x actuators at the rate of what is played
    [worker] */
double timesLimits (const TrackWork& work, const Eigen::MatrixXd& played);

/** The same by a device's limits. @param sampleRate  Hz, of what is played [worker] */
double timesLimits (const ModalModel&, double sampleRate, const Eigen::MatrixXd& played);
} // namespace antinode
