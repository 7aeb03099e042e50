#pragma once

#include "ElementResults.h"

#include <antinode_model/ModalModel.h>

#include <optional>

namespace antinode
{
/** Which side of a body is touched: its highest plane along an axis, or against it. */
struct SideChoice
{
    int axis = 2;        ///< 0 x, 1 y, 2 z: normal to the surface.
    bool isTop = true;   ///< False: the lowest plane.
    double flatness = 0; ///< m that nodes may lie behind the plane; 0: a thousandth of the surface's extent.
    int maximumPoints = 2000;
};

/** A ceramic as its forces show it, in the plane of the surface. */
struct LoadedArea
{
    double xMinimum = 0, xMaximum = 0, yMinimum = 0, yMaximum = 0; ///< m
};

/** The points of a finite-element body that are touched. N_p points. */
struct TouchedSurface
{
    std::vector<Eigen::Index> nodes; ///< N_p
    Eigen::MatrixX2d points;         ///< N_p x 2, m: the axes behind the normal one in the order x, y, z, x.
    std::vector<LoadedArea> ceramics;
    Eigen::Index meshNodes = 0; ///< Of the plane, before they were thinned.
    Eigen::Index lower = 0;     ///< Nodes that are the highest of their place and yet behind the plane: left out.
};

/** The flat surface of a body without its ceramics, whose materials have all nodes with reaction forces. Of nodes above
   each other the outermost counts; more points than wanted are thinned evenly.
    @throws InputError  where fewer than 3 points are left
    [worker] Docs/Theory.md, section 1.14. */
TouchedSurface findTouchedSurface (const ElementResults&, const SideChoice&);

/** What results of finite elements do not say. */
struct ImportSettings
{
    std::string name = "imported";
    SideChoice side;
    std::optional<SurfaceBoundary> boundary; ///< Where the surface ends; none: at the rectangle around its nodes.
    double caseVoltage = 1;                  ///< V, at which the ceramics of the cases strain.
    double dampingRatio = 0.01;              ///< Of modes for which the program says none.
    double voltageLimit = 150;               ///< V, of all ceramics.
    double fullScaleVoltage = 150;           ///< V
};

/** A device made of results of finite elements, and what speaks for it. */
struct ImportedDevice
{
    ModalModel model;
    Eigen::Index meshNodes = 0, nodesOfSurface = 0; ///< Before points were thinned.
    int leftOut = 0;                                ///< Modes that do not move the surface along its normal.
    int withoutDamping = 0;                         ///< Modes for which the program says no damping ratio.
    double mass = 0;                                ///< kg that the surface represents, from the shapes' norms.
    std::optional<double> totalMass;                ///< kg, as a table of the program says.
    std::vector<double>
        staticErrors; ///< A ceramic each: what the modes leave of its static displacement, RMS, relative.
    std::vector<std::string> warnings; ///< Sentences.
};

/** Modes on the surface, and of every ceramic its participation: alpha = - sum over nodes of reaction force . shape, by
    the voltage.
    @throws InputError  where there is no surface, a ceramic's case has no force, or no mode moves the surface
    [worker] Docs/Theory.md, section 1.14. */
ImportedDevice importDevice (const ElementResults&, const ImportSettings&);
} // namespace antinode
