#pragma once

#include "DriveAllocation.h"

#include <Eigen/Core>
#include <antinode_allocation/Allocation.h>
#include <antinode_model/ModalModel.h>
#include <antinode_model/VoltageProgram.h>

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

/** What the rows of a problem observe of complex modes. */
struct ComplexRowSet
{
    std::vector<StateRow> hard;   ///< Of which the problem has the first products already.
    std::vector<StateRow> guards; ///< Guarded with full weight.
    std::vector<StateRow> turned; ///< Guarded with the weight of the imaginary parts of their shapes.
};

/** Gives a problem the second products of its hard rows, and its guards. [worker] Docs/Theory.md, section 4.12. */
void addComplexRows (AllocationProblem&, const ModalModel&, const ComplexRowSet&, const DriveList&, Playback);

/** A quantity of complex modes under drives that are mixed by a matrix, one a row. [worker] */
Eigen::VectorXd complexRowValues (const ModalModel&, const std::vector<StateRow>&, const DriveList&,
                                  const Eigen::MatrixXd& matrix, Playback);

/** Takes from the wanted velocities of complex modes at every moment what the imaginary parts of shapes and the other
   modes add to the field, so that all together are the field that is wanted.
    @param moments  those of the design, with the velocities that the matrix was made for
    @return         the largest change, relative to the largest velocity
    [worker] Docs/Theory.md, section 4.12. */
double correctWanted (std::vector<FocusMoment>& moments, const FocusDesign&, const ModalModel&, const DriveList&,
                      const Eigen::MatrixXd& matrix);

/** Refuses what is not known to be right for complex modes.
    @throws InputError  when the modes are complex and the focus asks for it
    [any] */
void requireComplexModesSuit (const ModalModel&, const FocusDescription&);
} // namespace antinode
