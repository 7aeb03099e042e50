#pragma once

#include "FocusDescription.h"
#include "LessFelt.h"

#include <antinode_allocation/Allocation.h>
#include <antinode_model/ModalModel.h>
#include <antinode_model/SampledVoltages.h>

#include <optional>
#include <vector>

namespace antinode
{
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
   last one that playback lets act before the focus. Rows are exact for the playback; guards are soft. By least voltage
   the limits are lowered as near to the least voltage of any samples as the focus asks for, and at rates of 88.2 kHz
   and more only some samples are free, where that is near enough (SparseSamples.h). Where a slew limit binds, a
   low-pass makes edges slower, and single samples get lower limits.
    @param modes   the controlled modes, ascending
    @param wanted  their modal velocities at t_f, m/s kg^1/2
    @param limits  N_b, V
    @throws LimitError  where no waveform at all keeps the limits, or none was found that keeps a slew limit; InputError
   where there is no sample rate, or a mode cannot be moved [worker] Docs/Theory.md, section 4.9. */
FreeWaveform freeWaveform (const ModalModel&, const FocusDescription&, const std::vector<int>& modes,
                           const Eigen::VectorXd& wanted, const Eigen::VectorXd& limits, Playback);
} // namespace antinode
