#pragma once

#include "Field.h"

#include <antinode_base/Progress.h>
#include <antinode_learning/Retuning.h>
#include <antinode_responses/MeasuredResponse.h>
#include <antinode_structure/DeviceDescription.h>

#include <filesystem>
#include <string>
#include <vector>

namespace antinode
{
inline constexpr TaskText retuneText { "retune", "Updates a drifted device from the responses of a few points",
                                       "Docs/Theory.md, section 8.7" };

/** What retune is asked for. */
struct RetuneRequest
{
    DeviceDescription device; ///< Before the drift.
    std::vector<std::filesystem::path> files;
    KnownSpread spread;
    double placeDeviation = 1e-3; ///< m, of each coordinate of each point.
    bool usesCache = true;
};

/** [any] */
std::vector<Field> fields (RetuneRequest&);

/** The responses of all files together, as `frf` and `measure` write them. @throws InputError  as readMeasurement
    [worker] Docs/FileFormats.md. */
Measurement responsesOfFiles (const std::vector<std::string>& files);

/** A device before and after a drift. */
struct RetunedDevice
{
    DeviceDescription device;
    ModalModel before;
    RetunedModel now;
    std::vector<std::string> remarks; ///< Assumptions on the responses, as sentences.
};

/** A device as the responses of a few points say that it is now.
    @throws InputError  as readMeasurement, retune and solveDevice
    [worker] */
RetunedDevice retune (const RetuneRequest&, const ShowProgress&);

/** The device file. [worker] Docs/FileFormats.md. */
std::string retunedDeviceText (const RetunedDevice&);
} // namespace antinode
