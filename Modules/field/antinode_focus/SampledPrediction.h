#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_model/SampledVoltages.h>

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** The states y of modes at the instant of one sample per unit of modal force in each sample, exact for the playback: a
   held sample in closed form, a band-limited one by the integral of its kernel up to that instant.
    @param samples  N_s, how many there are
    @param focus    which of them the instant is that of, counted from 0; it may lie beyond them
    @return         modes x N_s, s
    [worker] Docs/Theory.md, sections 4.9 and 6.2. */
Eigen::MatrixXcd sampleResponses (const ModalModel&, const std::vector<int>& modes, Playback, Eigen::Index samples,
                                  Eigen::Index focus);

/** The voltages that samples stand for at any time, N_b. [any] Docs/Theory.md, section 6.2. */
Eigen::VectorXd voltagesAt (const SampledVoltages&, double time);

/** The states of all modes at any time under sampled voltages.
    @param time  s from the trigger
    @return      N_m values y_k
    [worker] Docs/Theory.md, section 4.9. */
Eigen::VectorXcd sampledStates (const ModalModel&, const SampledVoltages&, double time);

/** The largest voltage between the samples as well, searched at 8 instants per sample. V [worker] */
double intersamplePeak (const SampledVoltages&);
} // namespace antinode
