#pragma once

#include "DxfEntities.h"

namespace antinode
{
/** A SPLINE by its knots, control points and weights, drawn as arcs and lines.
    @throws InputError  with its name, where it is given by other points or its numbers do not fit
    [worker] Piegl and Tiller, The NURBS Book, section 4.1. */
std::vector<PathPiece> dxfSplinePieces (const DxfRecord&, const std::string& name, const DxfSetting&, int& edge);
} // namespace antinode
