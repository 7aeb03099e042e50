#pragma once

#include "TouchedSurface.h"

#include <antinode_model/ModalModel.h>

#include <optional>

namespace antinode
{
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
