#pragma once

#include "AudioBenchOptions.h"

#include <antinode_learning/LearningPasses.h>
#include <antinode_measurement/SimulatedBench.h>
#include <antinode_structure/DeviceDescription.h>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** What `antinode learn` is asked for. */
struct LearnOptions
{
    std::string focus = "demonstrator", device, folder = "antinode-learnt", pointsFile;
    std::vector<std::string> assignments, recorded;
    AudioBenchOptions audio;
    std::vector<int> idleCeramics; // counted from 1
    double idleScale = 1;          // mA per V
    int passes = 6;
    double rate = 96000, duration = 250, longestLatency = 30; // Hz, ms, ms
    std::optional<double> frequency, damping, participation;  // %; none: by where the modes come from
    double distortion = 2, enough = 0.1;                      // %
    double place = 2;                                         // mm
    std::optional<double> latency;                            // ms; none: looked for
    SimulatedBenchSettings bench;
    double benchDelay = 1.234567, benchCubic = 0; // ms, %
    bool isSimulated = false, isPlayed = false, usesCache = true, isQuiet = false;
};

/** What is learnt on. */
struct LearningSetup
{
    DeviceDescription described; ///< What is learnt.
    ModalModel device;           ///< With modes beyond its own and all of its ceramics.
    WideModel nominal;           ///< The same; idle ceramics move nothing.
    FocusDescription focus;
    Eigen::MatrixX2d places;     ///< Of the velocity sensors, m.
    std::vector<Sensor> sensors; ///< Those at places, then the idle ceramics.
    ModeSpread deviations;
};

/** @param places  of the velocity sensors, m
    @throws InputError  for anything that cannot be used [worker] */
LearningSetup learningSetup (const DeviceDescription&, FocusDescription, Eigen::MatrixX2d places, const LearnOptions&);

/** A recording with what the options say of its noise and its latency. [any] */
PlayedRecording withNoiseAndLatency (PlayedRecording, const LearnOptions&);

/** Where passes come from: folders of earlier ones, a simulated bench, or an audio device. It lives as long as these
    two.
    @throws InputError  as AudioBench
    [message thread] */
PassPlayer passesOf (const LearnOptions&, const LearningSetup&);

/** Plays what is asked for so that ceramics get the voltages that are given, as far as limits allow; the recording has
   the voltages that they acted on. It lives as long as the setup.
    @throws InputError  as lagFilters [any] */
PassPlayer undoingLags (PassPlayer, const LearningSetup&, double sampleRate);

/** How often and how long is played. [any] */
LearningSettings learningSettings (const LearnOptions&);
} // namespace antinode
