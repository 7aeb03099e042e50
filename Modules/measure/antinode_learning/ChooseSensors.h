#pragma once

#include "ModeSpread.h"
#include "PlayedVoltages.h"

#include <antinode_model/ModalModel.h>

#include <vector>

namespace antinode
{
/** What plays say of each mode: the eigenvalues of the information on its frequency, damping and participations, in
   squares of their standard deviations before, per (kg^-1/2)^2 of shape over noise. */
using PlayedInformation = std::vector<Eigen::VectorXd>;

/** @param sampleRate  that of the voltages, Hz
    @throws Cancelled  as checkWatch()
    [worker] Docs/Theory.md, section 7.8. */
PlayedInformation playedInformation (const ModalModel&, const ModeSpread&, const PlayedVoltages&);

/** What sensors tell in all: half of the logarithm of by how much the volume of what is possible shrinks, in bits.
    Between modes information is not shared.
    @param audibilities  N_m: the sum over the sensors of (shape over noise)^2
    [any] */
double informationBits (const PlayedInformation&, const Eigen::VectorXd& audibilities);

/** Sensors that are chosen among candidates. */
struct SensorChoice
{
    std::vector<Eigen::Index> chosen; ///< In the order in which they were added, the most informative first.
    std::vector<double> bits;         ///< What the first one, two... of them tell together.
};

/** The sensors that tell most together: one after the other, then exchanged one by one as long as that tells more
    (D-optimal; Fedorov 1972).
    @param audibilities  candidates x N_m: (shape over noise)^2
    @param count         1 to the number of candidates
    [worker] Docs/Theory.md, section 7.8. */
SensorChoice chooseSensors (const PlayedInformation&, const Eigen::MatrixXd& audibilities, Eigen::Index count);

/** Places for a sensor that tell most of all modes together, the best first: away from edges and from nodal lines.
    @return  at most count x 2, m
    @throws InputError  where there is none
    [worker] Docs/Theory.md, section 7.8. */
Eigen::MatrixX2d placesToMeasure (const ModalModel&, int count);
} // namespace antinode
