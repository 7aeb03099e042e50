#pragma once

#include "Field.h"

#include <antinode_base/Progress.h>
#include <antinode_import/ImportedDevice.h>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
inline constexpr TaskText importText { "import",
                                       "Makes a device from modes and reaction forces of a finite-element program",
                                       "Docs/Theory.md, section 1.14; Docs/Manual/importing.md" };

/** Results of a finite-element program, and which of its surfaces is touched. */
struct ImportRequest
{
    std::vector<std::filesystem::path> files;
    std::string normal = "z", side = "top", units = "SI"; ///< x, y, z; top, bottom; SI, mm
    std::filesystem::path outline;                        ///< As boundaryFrom.
    std::optional<double> flatness;                       ///< m; none: a thousandth of the surface's extent.
    std::optional<double> fullScaleVoltage;               ///< V; none: the voltage limit.
    ImportSettings settings;
};

/** [any] */
std::vector<Field> fields (ImportRequest&);

/** A device of what a finite-element program computed.
    @throws InputError  as readElementResults, boundaryFrom and importDevice
    [worker] */
ImportedDevice importDevice (const ImportRequest&, const ShowProgress&);

/** The device file. [worker] Docs/FileFormats.md. */
std::string importedDeviceText (const ImportedDevice&);
} // namespace antinode
