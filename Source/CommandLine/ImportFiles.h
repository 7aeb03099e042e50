#pragma once

#include <antinode_import/ImportedDevice.h>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The options of `antinode import`. */
struct ImportOptions
{
    std::vector<std::string> files;
    std::string normal = "z", side = "top", units = "SI"; ///< x, y, z; top, bottom; SI, mm
    std::string outline;                                  ///< As boundaryFrom.
    double flatness = 0;                                  ///< mm; 0: a thousandth of the surface's extent.
    std::optional<double> fullScaleVoltage;               ///< V; none: the voltage limit.
    ImportSettings settings;
};

/** A device of what a finite-element program computed.
    @throws InputError  as readElementResults, boundaryFrom and importDevice
    [worker] Docs/Theory.md, section 1.14. */
ImportedDevice importFiles (const ImportOptions&);

/** The device file. [worker] Docs/FileFormats.md. */
std::string importedDeviceText (const ImportedDevice&);
} // namespace antinode
