#pragma once

#include "FocusDescription.h"
#include "LimitUse.h"

#include <antinode_allocation/Allocation.h>
#include <antinode_base/InputError.h>
#include <antinode_model/ModalModel.h>
#include <antinode_model/VoltageProgram.h>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** A wanted field in terms of modes. Docs/Theory.md, section 2. */
struct ProjectedTarget
{
    Eigen::VectorXd field;           ///< N_p: v* on the points, m/s.
    Eigen::VectorXd modalVelocities; ///< N_m: v*_k, m/s kg^1/2.
    double energy = 0;               ///< K: integral m v*^2 dA less the rigid part, kg m^2/s^2.
    double rigidEnergy = 0;          ///< Of motion as a rigid body, which no ceramic reaches, kg m^2/s^2.
};

/** One of the foci of a train, or the only one: the targets that share one time. Docs/Theory.md, section 4.11. */
struct FocusMoment
{
    double time = 0; ///< s from the trigger.
    std::vector<Target> targets;
    ProjectedTarget target;
    Eigen::VectorXd wanted;         ///< Of the controlled modes: their velocities at that time, m/s kg^1/2.
    Eigen::VectorXd truncatedField; ///< N_p: the part of the wanted field that the controlled modes represent, m/s.
    double captured = 0;            ///< sqrt (S/K)
};

/** What of a focus lies in modes that the device does not say. Docs/Theory.md, section 5.2. */
struct SpillOver
{
    int knownModes = 0;           ///< The device's own.
    int guardedBeyond = 0;        ///< Of those beyond, how many the design guards.
    int playedModes = 0;          ///< All together.
    double designedFrequency = 0; ///< The highest that is designed for or guarded, Hz.
    double playedFrequency = 0;   ///< The highest that is played, Hz.
    double share = 0;             ///< RMS of the field in modes beyond the known ones / RMS of the whole field.
    double unguardedShare = 0;    ///< The same of the design that guards none of them.
    double unguardedPeak = 0;     ///< V that the design needs that guards none of them.
    std::string obstacle; ///< Why there are no modes to widePlay times the designed frequency; empty: there are.
};

/** A whole design: what is wanted, what is controlled, what is played. Written as design.json. */
struct FocusDesign
{
    FocusDescription description;
    ProjectedTarget target;
    std::vector<int> controlledModes; ///< Ascending mode indices.
    std::vector<double> growth;       ///< gamma of each controlled mode.
    std::vector<int> cycles;          ///< N of each controlled mode.
    Eigen::VectorXd truncatedField;   ///< N_p: the part of the wanted field that the controlled modes represent, m/s.
    double captured = 0;              ///< sqrt (S/K), 1 is best: the paper's Table C.1.
    double residue = 0;               ///< sqrt (1 - S/K).
    std::vector<FocusMoment>
        moments; ///< By time, the earliest is what the five above speak of. One where it is no train.
    std::optional<double>
        restTime; ///< s after the last focus: the brake has then brought all to rest. None without a brake.
    std::optional<double>
        shortestPeriod; ///< s: the program may be repeated so often and less. None if it was not computed.
    VoltageProgram program;
    AllocationCertificate certificate;
    double minimumPeakVoltage = 0; ///< V: the least peak of these drives and rows where the solver computed it, else 0.
    double reachablePeakVelocity = 0; ///< m/s: what the limit allows where it cannot be met; else the wanted one.
    double lowerBoundVoltage = 0; ///< V: certified; no waveform reaches the terminal velocities within t_f below it; 0
                                  ///< where it was not computed.
    double lowerBoundGap =
        0; ///< (upper - lower) / upper, upper the peak of a waveform that was found; 1: none was found.
    std::optional<LimitUse> limit; ///< The limit of which most is used. None if it was not computed.
    double intersamplePeakVoltage =
        0;             ///< V: of a free waveform, also between its samples; 0 where it was not computed.
    Playback playback; ///< The playback for which the terminal rows were computed.
    std::optional<SpillOver> spillOver; ///< None where no modes beyond the device's own were looked for.
    std::string weighing; ///< How the number of modes was chosen, a sentence or two; empty where it was given.
    std::vector<std::string> choices;  ///< What was chosen and why, in sentences.
    std::vector<std::string> warnings; ///< In sentences.
};

/** The wanted focus cannot be reached within the limits. The text gives what the drives need at least, in the unit of
    the limit, and the highest feasible velocity. */
class LimitError : public InputError
{
public:
    LimitError (const std::string& where, const std::string& wrong, double minimumPeakVoltageToUse,
                double reachableVelocityToUse);

    double minimumPeakVoltage; ///< V: the least peak of these drives that reaches the wanted field.
    double reachableVelocity;  ///< m/s: the peak velocity that the limit allows.
};

/** @param design      with its program, its certificate and the peak velocity that was wanted
    @throws LimitError  when its allocation shows that the limits cannot be met: which one, where, when, and what it
   would take
    [worker] */
void throwWhereBeyondLimit (const FocusDesign& design, const ModalModel&);
} // namespace antinode
