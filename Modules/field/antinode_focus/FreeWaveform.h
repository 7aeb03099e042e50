#pragma once

#include "FocusDescription.h"
#include "WaveformProblem.h"

#include <antinode_allocation/Allocation.h>
#include <antinode_model/ModalModel.h>
#include <antinode_model/VoltageProgram.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
/** What a free waveform reached where less was to be felt elsewhere, in terms of the modes that it is designed for. */
struct LessFelt
{
    double gain = 0;      ///< dB: by how much the weighted energy there is less than that of the design without it.
    double weight = 0;    ///< What the limits allow of the wanted one.
    double share = 1;     ///< Of the way from that design to the compromise of this weight; below 1 where limits allow
                          ///< next to none.
    double plainPeak = 0; ///< V that the design without it needs.
    int iterations = 0;   ///< Of conjugate gradients.
    double residual = 0;  ///< Of the compromise: |slope| / |slope of the design without it|.
};

/** The samples of least energy that give the controlled modes their velocities within the voltage limit. */
struct FreeWaveform
{
    SampledVoltages voltages;
    AllocationCertificate
        certificate;     ///< Its peak ratio is that of the samples, its objective 1/2 sum u^2 with the guards' part.
    double edgeTime = 0; ///< s: time constant of edges for the sake of a slew limit; 0: as short as samples allow.
    double tolerantPeakRatio = 0; ///< Of robust ones: no free samples whose expected error is as small have a lower
                                  ///< peak. A share of the limits.
    std::optional<LessFelt> felt; ///< Where less was to be felt elsewhere; the objective is that without it.
};

/** Every sample is free: from the beginning (the trigger, or where a window or the maximum duration says) up to the
   last one that playback lets act before the focus. Rows are exact for the playback; guards are soft. Near the
   bound the limits are lowered as near to the least voltage of any samples as the focus asks for, and at rates of 88.2
   kHz and more only some samples are free, where that is near enough (FreeSamples.h). Where a slew limit binds, a
   low-pass makes edges slower, and single samples get lower limits.
    @param modes   the controlled modes, ascending
    @param wanted  their modal velocities at t_f, m/s kg^1/2
    @param limits  N_b, V
    @throws LimitError  where no waveform at all keeps the limits, or none was found that keeps a slew limit; InputError
   where there is no sample rate, or a mode cannot be moved [worker] Docs/Theory.md, section 4.9. */
FreeWaveform freeWaveform (const ModalModel&, const FocusDescription&, const std::vector<int>& modes,
                           const Eigen::VectorXd& wanted, const Eigen::VectorXd& limits, Playback);

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

/** The waveform of a task that keeps the slew limits of the model, at 8 places per sample, as solveWithEdges gives it
   where it keeps them.
    @return  with the time constant of its edges, s
    @throws LimitError  where none was found; InputError as solveWithEdges
    [worker] Docs/Theory.md, section 4.9. */
std::pair<SolvedWaveform, double> solveWithinSlews (const WaveformTask&);
} // namespace antinode
