#pragma once

#include "Chart.h"

#include <antinode_focus/FocusDesign.h>
#include <antinode_model/ModalModel.h>
#include <antinode_model/Surface.h>

#include <string>
#include <vector>

namespace antinode
{
/** A velocity field over a plate: ceramics outlined, a cross on every focus, contours at plus and minus half of the
   peak, nodal lines thin.
    @param field  N_p values, m/s
    @param label  the meaning of the colours; the unit mm/s is added
    [worker] */
HeatMap plateFieldChart (const ModalModel&, const Eigen::VectorXd& field, const std::string& label,
                         const std::vector<Target>&);

/** The wanted, the truncated and the reached field of a plate in the same colours, and the difference of reached and
   wanted in its own: two by two.
    @param reached  N_p values, m/s
    [worker] */
ChartGrid plateFieldsChart (const ModalModel&, const FocusDesign&, const Eigen::VectorXd& reached);

/** A direction along a side of a plate. */
enum class PlateDirection
{
    alongX,
    alongY
};

/** A cross section of a plate through its first focus: wanted, truncated, reached, with the ceramics that it passes.
    @param reached  N_p values, m/s
    [worker] */
LineChart crossSectionChart (const ModalModel&, const FocusDesign&, const Eigen::VectorXd& reached, PlateDirection);

/** Paths as lines close enough for any picture, mm. [any] */
MapShape shapeOf (const Outline&);

/** The outline of a plate that does not fill its extent, mm; else empty. [any] */
MapShape surfaceShape (const Surface&);

/** The ceramics of a plate in mm, with their names. [any] */
std::vector<MapRectangle> ceramicRectangles (const ModalModel&);

/** The height at which maps of a plate, in the given number of columns and rows, fill a picture of this width with
    their axes. [any] */
int plateFigureHeight (const Surface&, int width, int columns, int rows);

/** Fields on a plate's points at other places of it.
    @param fields  N_p x N
    @param places  M x 2: x and y, m
    @return        M x N; not a number beyond the boundary of a surface
    [worker] Docs/Theory.md, section 1.5. */
Eigen::MatrixXd fieldsAt (const Surface&, const Eigen::MatrixXd& fields, const Eigen::MatrixX2d& places);

/** Fields on a plate's points as maps of square cells, a row for each y from below: at most so many cells along the
   longer side, and no more than 64 where the points lie on no grid, because there each cell has a spline of its own.
    Beyond the boundary of a surface a map has what is nearest: it is to be clipped there.
    @param fields  N_p x N
    @return        N maps
    [worker] Docs/Theory.md, section 1.5. */
std::vector<Eigen::MatrixXd> fieldMaps (const Surface&, const Eigen::MatrixXd& fields, int maximumCells);
} // namespace antinode
