#pragma once

#include "Allocation.h"
#include "FocusDescription.h"

#include <antinode_model/ModalModel.h>
#include <antinode_model/Oscillation.h>
#include <antinode_model/Playback.h>

#include <string>
#include <vector>

namespace antinode
{
/** What a wanted field is in terms of modes. Docs/Theory.md, section 2. */
struct ProjectedTarget
{
    Eigen::VectorXd field;           ///< N_p: v* on the points, m/s.
    Eigen::VectorXd modalVelocities; ///< N_m: v*_k, m/s kg^1/2.
    double energy = 0;               ///< K = integral m v*^2 dA, kg m^2/s^2.
};

/** A whole design: what is wanted, what is controlled, what is played. Written as design.json. */
struct FocusDesign
{
    FocusDescription description;
    ProjectedTarget target;
    std::vector<int> controlledModes; ///< Ascending mode indices.
    std::vector<double> growth;       ///< gamma of each controlled mode.
    std::vector<int> cycles;          ///< N of each controlled mode.
    Eigen::VectorXd truncatedField;   ///< N_p: the part of the wanted field that the controlled modes carry, m/s.
    double captured = 0;              ///< sqrt (S/K), 1 is best: the paper's Table C.1.
    double residue = 0;               ///< sqrt (1 - S/K).
    VoltageProgram program;
    AllocationCertificate certificate;
    double leastPeakVoltage = 0; ///< V: the least peak of these drives and rows where the solver computed it, else 0.
    double reachablePeakVelocity = 0; ///< m/s: what the limit allows where it cannot be met; else the wanted one.
    double lowerBoundVoltage =
        0; ///< V: certified; no waveform reaches the terminal velocities within t_f below it; 0 where it was not computed.
    double intersamplePeakVoltage =
        0;             ///< V: of a free waveform, also between its samples; 0 where there are no samples.
    Playback playback; ///< What the terminal rows were computed for.
    std::vector<std::string> choices;  ///< What was chosen and why, in plain words.
    std::vector<std::string> warnings; ///< In plain words.
};
} // namespace antinode
