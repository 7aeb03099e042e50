#pragma once

#include "FocusDescription.h"
#include "PlayedWaveform.h"

#include <antinode_model/ModalModel.h>

#include <string>
#include <vector>

namespace antinode
{
/** What a free waveform is made for. It refers to its parts. */
struct WaveformTask
{
    const ModalModel& model;
    const FocusDescription& description;
    const std::vector<int>& modes;
    const std::vector<int>& guards;
    const Eigen::VectorXd& wanted;
    const Eigen::VectorXd& limits;
    Playback playback;

    bool isNearItsBound() const { return description.allocation.method == AllocationMethod::leastVoltage; }
};

/** A waveform, and what it was solved from. */
struct SolvedWaveform
{
    PlayedProblem problem;
    PlayedWaveform waveform;
};

/** The waveform of a task, of as sparse samples as reach it.
    @param edgeTime  s: time constant of the low-pass through which free samples are played; 0: none
    @throws LimitError, InputError  where the voltage limits do not allow it
    [worker] Docs/Theory.md, section 4.9. */
SolvedWaveform solveWithEdges (const WaveformTask&, double edgeTime);

/** Where the largest of the voltage limits is set, as errors name it. [any] */
std::string largestLimitField (const WaveformTask&);

/** Of all targets, m/s. [any] */
double largestVelocity (const FocusDescription&);

/** Whether such a voltage limit can be kept is not known, or it can and the search for the least energy did not end.
    @throws InputError  always [any] */
[[noreturn]] void throwTooNear (const std::string& field, double limit, double minimumPeakRatio);
} // namespace antinode
