#pragma once

#include <Eigen/Core>
#include <antinode_fingers/Finger.h>
#include <antinode_model/ModalModel.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace antinode
{
/** Frequencies from a lower to an upper one, Hz. */
struct TrackBand
{
    double lower = 40, upper = 1000;
};

/** Ricker's wavelet, the shortest pulse without offset. */
struct ClickSignal
{
    double frequency = 250; ///< Of the largest line of its spectrum, Hz.
};

/** A tone under a Gaussian envelope. */
struct GaborSignal
{
    double frequency = 200; ///< Hz
    double width = 0.02;    ///< Of the envelope at half of its height, s.
};

/** A tone that rises and falls as a raised cosine; with a modulation, its amplitude swings. */
struct ToneSignal
{
    double frequency = 250;         ///< Hz
    double duration = 0.3;          ///< s
    double attack = 0.02;           ///< Of rise and fall each, s.
    double modulationFrequency = 0; ///< Hz; 0: none.
    double modulationDepth = 1;     ///< 0 to 1: the share by which the amplitude falls.
};

/** Noise of even power within the band, which rises and falls as a tone does. */
struct NoiseSignal
{
    double duration = 0.3;  ///< s
    double attack = 0.02;   ///< s
    std::uint64_t seed = 1; ///< Another seed, another noise; the same on every computer.
};

/** A recording. What lies outside the band is removed, 5 ms at both ends are faded. */
struct SampledSignal
{
    std::string source;      ///< The file's name.
    double sampleRate = 0;   ///< Hz
    Eigen::VectorXd samples; ///< Any unit.
};

/** A moment of a vibration. */
struct VibrationPoint
{
    double time = 0;      ///< s after the first point.
    double amplitude = 0; ///< Any unit.
    double frequency = 0; ///< Hz
};

/** A tone whose amplitude and frequency follow straight lines. What lies outside the band is removed, which takes 5 ms
    before the first point and after the last one. */
struct VibrationSignal
{
    std::vector<VibrationPoint> points; ///< At least two, ascending in time, from 0 on.
};

using TrackSignal = std::variant<ClickSignal, GaborSignal, ToneSignal, NoiseSignal, SampledSignal, VibrationSignal>;

/** How long a signal lasts, s. [any] */
double signalDuration (const TrackSignal&);

/** A signal from its begin to its end at a rate, in no unit: 0 before and after.
    @param sampleRate  Hz, at least 3 times the band's upper frequency
    @return            N_s samples, the last one not before the signal's end
    [worker] Docs/Theory.md, section 4.13. */
Eigen::VectorXd signalSamples (const TrackSignal&, TrackBand, double sampleRate);

/** What the level of an event is. */
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

/** Where a moving point is at one time. */
struct PathPoint
{
    double time = 0;     ///< s after the trigger.
    double x = 0, y = 0; ///< m
};

/** A place that is touched. */
struct TouchedPoint
{
    std::string name;
    double x = 0, y = 0;          ///< m, where the path begins if there is one; NaN: it has no place yet.
    std::optional<Finger> finger; ///< What rests there; none: nothing that changes the motion.
    std::vector<PathPoint> path;  ///< Ascending in time, straight lines in between; empty: it stays.
};

/** A signal at a time. */
struct TrackEvent
{
    TrackSignal signal;
    TrackLevel level;
    double amplitude = 1; ///< The share of its level that it has, above 0.
    double start = 0;     ///< s after the trigger, at least 0.
};

/** What one finger is to feel: the displacement of the surface beneath it, the sum of events. */
struct Track
{
    TouchedPoint point;
    std::vector<TrackEvent> events = std::vector<TrackEvent> (1); ///< At least one.
};

/** Waveforms at touched points: every track at its own point, nothing at the others. */
struct WaveformsDescription
{
    std::string name;
    TrackBand band;
    double preRoll = 0.01, postRoll = 0.02; ///< s of voltages before the first and after the last track.
    std::vector<Track> tracks;              ///< At least one.
    std::vector<TouchedPoint> silent;       ///< Fingers that are to feel nothing.
    std::vector<std::string> warnings;      ///< Sentences of its reader.
};

/** Tracks at one place, or along one path, as one with the events of all and the finger of the first that has one. A
    warning names them. [any] */
WaveformsDescription withSummedTracks (WaveformsDescription);

/** All touched points, those with tracks first. [any] */
std::vector<TouchedPoint> touchedPoints (const WaveformsDescription&);

/** The fingers at these points that load the surface. [any] */
std::vector<Finger> restingFingers (const WaveformsDescription&);

/** A touched point as a file numbers it: "track 2", "silent finger 1". @param point  index in touchedPoints [any] */
std::string pointInWords (const WaveformsDescription&, std::size_t point);

/** Where a touched point is, s after the trigger: before its path at its begin, behind it at its end. [any] */
PathPoint placeAt (const TouchedPoint&, double time);

/** The same waveforms at points that stay where they are at a time. [any] */
WaveformsDescription stillAt (const WaveformsDescription&, double time);

/** Times between which all points together move a step or less, from the begin of the first path to the end of the
    last, ascending; one where nothing moves.
    @param step       m
    @param mostSteps  with longer steps if need be
    [any] */
std::vector<double> timesOfPlaces (const WaveformsDescription&, double step,
                                   int mostSteps = std::numeric_limits<int>::max());

/** How long the tracks are, from the trigger to the end of the last, s. [any] */
double tracksDuration (const WaveformsDescription&);

/** Checks that all points have a place and stay on a surface; a path has times that ascend, at most 2 m/s and 10 m, and
   no finger on it.
    @throws InputError  which point, where, what is allowed [any] */
void requirePlaces (const Surface&, const WaveformsDescription&);

/** The mode shapes of the touched points where they begin: points x N_c, kg^-1/2.
    @throws InputError  as requirePlaces
    [worker] */
Eigen::MatrixXd touchedShapes (const ModalModel&, const WaveformsDescription&);
} // namespace antinode
