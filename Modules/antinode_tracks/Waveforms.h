#pragma once

#include "TrackSignal.h"

#include <antinode_fingers/Finger.h>
#include <antinode_model/ModalModel.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** What the level of a track is. */
enum class LevelKind
{
    displacement, ///< Its largest displacement, m.
    velocity,     ///< Its largest velocity, m/s.
    sensation     ///< Its sensation level, dB over threshold.
};

struct TrackLevel
{
    LevelKind kind = LevelKind::displacement;
    double value = 5e-6;
};

/** A place that is touched. */
struct TouchedPoint
{
    std::string name;
    double x = 0, y = 0;          ///< m
    std::optional<Finger> finger; ///< What rests there; none: nothing that changes the motion.
};

/** What one finger is to feel: the displacement of the surface beneath it. */
struct Track
{
    TouchedPoint point;
    TrackSignal signal;
    TrackLevel level;
    double start = 0; ///< s after the trigger, at least 0.
};

/** Waveforms at touched points: every track at its own point, nothing at the others. */
struct WaveformsDescription
{
    std::string name;
    TrackBand band;
    double preRoll = 0.01, postRoll = 0.02; ///< s of voltages before the first and after the last track.
    std::vector<Track> tracks;              ///< At least one.
    std::vector<TouchedPoint> silent;       ///< Fingers that are to feel nothing.
};

/** All touched points, those with tracks first. [any] */
std::vector<TouchedPoint> touchedPoints (const WaveformsDescription&);

/** A touched point as a file numbers it: "track 2", "silent finger 1". @param point  index in touchedPoints [any] */
std::string pointInWords (const WaveformsDescription&, std::size_t point);

/** How long the tracks are, from the trigger to the end of the last, s. [any] */
double tracksDuration (const WaveformsDescription&);

/** Where the shapes of the touched points are: points x N_c, kg^-1/2.
    @throws InputError  for a point outside the surface: which, where, what is allowed
    [worker] */
Eigen::MatrixXd touchedShapes (const ModalModel&, const WaveformsDescription&);
} // namespace antinode
