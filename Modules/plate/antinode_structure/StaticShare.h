#pragma once

#include "BendingModes.h"
#include "DeviceDescription.h"
#include "PlateSolution.h"

namespace antinode
{
/** The modes and, for every patch with a moment, one more shape behind them, so that together they have the whole
   static deflection under these moments, but for rigid motions. Those shapes are right far below their frequencies
   only.
    @throws InputError  where the modes are too few for what they leave to be found
    [worker] Docs/Theory.md, section 1.8. */
BendingModes withStaticRest (const BendingProblem&, BendingModes);

/** The static deflection of a plate under one volt on each ceramic: all modes at once, without rigid motions.
    @return  unknowns x N_b: coefficients of splines, m/V
    [worker] Docs/Theory.md, section 1.8. */
Eigen::MatrixXd staticDeflections (const PlateDescription&, const PlateSolution&);

/** The modes and, per ceramic, one more shape, so that together they have the whole static deflection: Ritz's vectors
   of what the modes leave of it. These stand behind the modes, higher in frequency; they are exact far below their
    frequencies only.
    [worker] Docs/Theory.md, section 1.8. */
PlateSolution withStaticShare (const PlateDescription&, PlateSolution);

/** Whether a device has a static share behind its modes: plates with ceramics, of any outline, also retuned ones, and
    devices of which it was measured. [any] */
bool hasStaticShare (const DeviceDescription&);

/** A device as solveStructure gives it, with the static share of all higher modes where it is a plate or was measured;
    other devices have their modes alone.
    @throws InputError, Cancelled  as solveStructure [worker] */
ModalModel solveWithStaticShare (const DeviceDescription&, std::optional<int> modeCount);
} // namespace antinode
