#pragma once

#include "BenchFields.h"

#include <antinode_base/Progress.h>
#include <antinode_focus/FocusDescription.h>
#include <antinode_learning/LearningPasses.h>
#include <antinode_measurement/SimulatedBench.h>
#include <antinode_structure/DeviceDescription.h>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
inline constexpr TaskText learnText {
    "learn", "Improves a focus from recordings of its plays: learns the modes, designs it again",
    "Docs/Theory.md, section 7.6"
};

/** A focus, sensors, and where plays come from. */
struct LearnRequest
{
    FocusDescription focus;
    DeviceDescription device;
    Eigen::MatrixX2d places = Eigen::MatrixX2d (0, 2); ///< Of the velocity sensors, m.
    std::vector<int> idleCeramics;                     ///< Counted from 1.
    std::vector<std::filesystem::path> recorded;       ///< Folders of earlier passes.
    PlayFunction play;
    bool isSimulated = false, isPlayed = false; ///< Played: through the audio device.
    BenchWiring wiring;
    double idleScale = 1; ///< mA per V
    int passes = 6;
    double enough = 0.001; ///< Estimated field error after which no more is played.
    double sampleRate = 96000, duration = 0.25, longestLatency = 0.03; ///< Hz, s, s
    std::optional<double> frequency, damping, participation; ///< Deviations; none: by the origin of the modes.
    double distortion = 0.02;
    double place = 0.002;          ///< m
    std::optional<double> latency; ///< s; none: looked for.
    SimulatedBenchSettings bench { .delay = 1.234567e-3 };
    bool usesCache = true;
};

/** [any] */
std::vector<Field> fields (LearnRequest&);

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

/** What was learnt, and on what. */
struct LearntDevice
{
    LearningSetup setup;
    LearningSettings settings;
    LearntFocus learnt;
};

/** Improves a focus by its plays: those of folders, of a simulated bench, of an audio device or of a function; with
   none of them the design is made that is to be played first.
    @throws InputError  for anything that cannot be used, and as learnFocus and openAudioBench
    [worker] */
LearntDevice learn (const LearnRequest&, const ShowProgress&);
} // namespace antinode
