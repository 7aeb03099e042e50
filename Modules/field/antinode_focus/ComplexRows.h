#pragma once

#include "DriveAllocation.h"
#include "StateRows.h"

#include <antinode_allocation/Allocation.h>

namespace antinode
{
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
