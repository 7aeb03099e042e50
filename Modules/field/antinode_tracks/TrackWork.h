#pragma once

#include "TouchedNodes.h"
#include "TrackDesign.h"
#include "Waveforms.h"
#include "WindowedResponses.h"

#include <Eigen/Core>
#include <antinode_fingers/Sensation.h>

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

/** What is asked of whatever ceramics play. */
struct TrackProblem
{
    TrackSpan span;
    MovingPoints moving;      // empty where nothing moves
    PointResponses responses; // of the nodes
    Eigen::MatrixXd wanted;   // length x points
};

/** The responses of a device at the rate of a design, and what is wanted. @throws InputError  as designTracks [worker]
 */
TrackProblem trackProblem (const ModalModel&, const WaveformsDescription&, const TrackSettings&);

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

/** What the touched points are to do from the trigger to the end of the last track, at its levels; silence is 0.
    @return  N_s x points, m: the last sample not before the end
    @throws InputError  for a track without motion in the band
    [worker] Docs/Theory.md, section 4.13. */
Eigen::MatrixXd wantedMotion (const WaveformsDescription&, const SkinThreshold&, double sampleRate);

/** What a design of tracks holds at once, bytes. */
struct TrackBytes
{
    double samples = 0; ///< Of all that is the longer the longer tracks last.
    double tables = 0;  ///< Of the shapes along paths.

    double sum() const { return samples + tables; } // [any]
};

/** What a design with such samples holds. [any] */
TrackBytes trackBytes (const ModalModel&, const WaveformsDescription&, const TrackSpan&, const TouchedNodes&);

/** Whether that is as much as designs may hold, 1 GiB, or less. [any] */
bool isWithinMemory (TrackBytes);

/** Checks the same. @param seconds  that the tracks last
    @throws InputError  how much it is, and how long tracks may last
    [any] */
void requireTrackMemory (TrackBytes, double seconds);

/** Checks, before they are computed, that the shapes along all paths are within it too.
    @throws InputError  how much they take, and which share of the paths' length is allowed
    [any] */
void requirePathMemory (const ModalModel&, const WaveformsDescription&);

/** Puts what a shift asks for in place of what is wanted. @throws Cancelled  when a watch of this thread says no
    [worker] Docs/Theory.md, section 4.15. */
void applyShift (TrackWork&, const TrackShift&, TrackBand);
} // namespace antinode
