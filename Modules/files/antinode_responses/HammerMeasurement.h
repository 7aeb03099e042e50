#pragma once

#include "RecordedSignals.h"
#include "UniversalFile.h"

#include <antinode_measurement/HammerResponses.h>

#include <tuple>

namespace antinode
{
/** Options of a hammer test. */
struct HammerOptions
{
    HammerSettings hits;
    ResponseEstimator estimator = ResponseEstimator::h1;
    double lowestFrequency = 0, highestFrequency = 0; ///< Hz; highest 0: as far as the force drives.
    MeasurementOptions stated;                        ///< Units that override the files', places of points.
    double responseScale = 1, forceScale = 1;         ///< What a sample of 1 is in these units.
    std::string hitPoint;                             ///< Point at which the hammer hits; empty: as the files say.
};

/** A point in one direction. */
struct HammerPoint
{
    std::string name;
    int axis = 3; ///< 1 to 3: x, y, z.

    bool operator== (const HammerPoint&) const = default;

    /** For sets. */
    bool operator<(const HammerPoint& other) const { return std::tie (name, axis) < std::tie (other.name, other.axis); }
};

/** The outcome of a hammer test. N points in one direction each. */
struct HammerMeasurement
{
    std::vector<HammerRecording> recordings;
    HammerTest test;
    std::vector<HammerPoint> points;        ///< N: directions of a triaxial sensor are points of their own here.
    FrequencyResponses responses;           ///< Velocities per newton at i omega + test.windowDecay; points repeat.
    std::vector<Eigen::MatrixXd> coherence; ///< As responses.values; NaN where one hit alone was left.
    std::vector<std::string> remarks;       ///< What was assumed, as sentences.
};

/** Frequency responses from recordings of a hammer: hits of recordings of the same points and the same hit point are
    averaged; others are further points and references.
    @throws InputError  as examineHits, drivenLines and hammerResponses, and where places do not fit the points
    [worker] Docs/Theory.md, section 8.11. */
HammerMeasurement measureByHammer (const std::vector<RecordingFile>&, const HammerOptions&);

/** As responseSets, with directions and coherences, points that are numbers with their own node numbers, and the decay
    rate of the exponential window in a text line, by which `identify` takes it off again. [worker] */
std::vector<UniversalSet> hammerSets (const HammerMeasurement&);
} // namespace antinode
