#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_model/Oscillation.h>
#include <antinode_model/Playback.h>

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** The observed quantity of a mode. All are in m/s kg^1/2, so that their errors have equal weight. */
enum class ModalQuantity
{
    velocity,      ///< q'
    displacement,  ///< b q, b the damped angular frequency.
    turnedVelocity ///< That of a quarter turn ahead, which moves the imaginary part of a complex shape.
};

/** What acts on the modes of rows. A complex participation is a real force and one that is turned by j. */
enum class ForceTurn
{
    none,
    quarter ///< The force is j times the drive.
};

/** One number of a mode's motion at one time: what a row of the allocation prescribes. */
struct StateRow
{
    int mode = 0;
    double time = 0; ///< s from the trigger.
    ModalQuantity quantity = ModalQuantity::velocity;
};

/** One row of a quantity a mode, at one time. [any] */
std::vector<StateRow> rowsAt (double time, const std::vector<int>& modes, ModalQuantity);

/** The response of each row to each drive per unit participation: C (r, l), the quantity of row r when drive l alone
   acts on its mode with participation 1. Played band-limited, a drive and its release are what they are as continuous
   waveforms, so one closed form serves both; held samples have their own exact sum.
    @param drives  the oscillations of each drive l
    @return        rows x drives, (m/s kg^1/2) / (N kg^-1/2)
    [worker] Docs/Theory.md, sections 4.1, 4.12 and 6.3. */
Eigen::MatrixXd rowResponses (const ModalModel&, const std::vector<StateRow>& rows,
                              const std::vector<std::vector<Oscillation>>& drives, Playback,
                              ForceTurn = ForceTurn::none);
} // namespace antinode
