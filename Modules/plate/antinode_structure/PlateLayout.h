#pragma once

#include "PlateSection.h"

#include <antinode_numerics/SplineAxis.h>

#include <vector>

namespace antinode
{
/** The rectangle of a ceramic, by the lines that bound it. */
struct PlatePatch
{
    Eigen::Index left = 0, right = 0, bottom = 0, top = 0; ///< Indices of lines.
};

/** The lines at which a plate's section changes, with lengths in units of its longer side. */
struct PlateLayout
{
    double unit = 0;                 ///< The longer side, m.
    Eigen::VectorXd linesX, linesY;  ///< The plate's edges and those of its ceramics, ascending.
    std::vector<PlatePatch> patches; ///< Of each ceramic.
};

/** Lines closer than a 5000th of the shorter side become one: so much less than the plate's waves is not seen by them,
   and cells much narrower than others cost digits. Opposite edges of one ceramic stay apart.
    @throws InputError  when a ceramic is narrower than that
    [worker] */
PlateLayout makeLayout (const PlateDescription&);

/** A ceramic as it lies between its lines. [any] */
CeramicDescription onLines (const PlateDescription&, const PlateLayout&, std::size_t ceramic);

/** The resolution of an axis. Docs/Theory.md, section 1.6. */
struct PlateResolution
{
    int degree = 5;           ///< Of the splines.
    double largestCell = 0.1; ///< In units of the longer side.
    int layers = 2;           ///< Cells that shrink towards every line, on either side.
    double layerRatio = 0.25; ///< By which each is smaller than the one before.
};

/** The splines' breaks between the lines of one axis: cells of equal size in each segment, smaller towards its ends.
   Bending moments may jump on the lines, so only the slope is continuous there; the axis' ends are held as the plate's
   edges are. [worker] */
SplineBreaks divide (const Eigen::VectorXd& lines, const PlateResolution&, EdgeCondition start, EdgeCondition end);
} // namespace antinode
