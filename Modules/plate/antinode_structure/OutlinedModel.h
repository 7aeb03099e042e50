#pragma once

#include "DeviceDescription.h"

#include <optional>

namespace antinode
{
/** A plate of any outline, solved and put on a grid. @throws InputError [worker] Docs/Theory.md, section 1.13. */
ModalModel solveOutlinedPlate (const std::string& name, const OutlinedPlate&, std::optional<int> modeCount);

/** The modes to some percent, in a small part of the time: what a plate has while it is being drawn.
    @throws InputError  as solveOutlinedPlate [worker] */
ModalModel solveOutlinedCoarsely (const std::string& name, const OutlinedPlate&, int modeCount);

/** The modes, and behind them the static share of all higher ones: one shape more for every ceramic. Errors of
   frequencies are not estimated. @throws InputError  as solveOutlinedPlate, and where the modes are too few for it
    [worker] Docs/Theory.md, section 1.8. */
ModalModel solveOutlinedWithStaticShare (const std::string& name, const OutlinedPlate&, std::optional<int> modeCount);

/** The modes that a plate asks for, as solveOutlinedPlate gives them, but on the points of its first ones.
    @param fewer  how many these are
    @throws InputError  as solveOutlinedPlate
    [worker] Docs/Theory.md, section 5.2. */
ModalModel solveOutlinedOnPointsOfFewer (const std::string& name, const OutlinedPlate&, int fewer);

/** The thin plate of one section that is solved in place of a plate. [any] Docs/Theory.md, section 1.15. */
OutlinedPlate asSolved (const OutlinedPlate&, std::optional<int> modeCount);

/** A rectangular plate as one with an outline, whose edges are bottom, right, top and left: for what only that solver
   takes, ceramics that are turned or round. [any] */
OutlinedPlate outlinedPlate (const PlateDescription&);
} // namespace antinode
