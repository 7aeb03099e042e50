#pragma once

#include <antinode_learning/Retuning.h>
#include <antinode_responses/MeasuredResponse.h>
#include <antinode_structure/DeviceDescription.h>

#include <string>
#include <vector>

namespace antinode
{
/** A device before and after a drift. */
struct RetunedDevice
{
    DeviceDescription device;
    ModalModel before;
    RetunedModel now;
    std::vector<std::string> remarks; ///< What was assumed of the responses, as sentences.
};

/** The responses of all files together, as `frf` and `measure` write them. @throws InputError  as readMeasurement
    [worker] Docs/FileFormats.md. */
Measurement responsesOfFiles (const std::vector<std::string>& files);

/** Standard deviations of a device from its model, as options say them. */
struct RetuneDeviations
{
    double frequency = 2;     ///< %, of each frequency.
    double drift = 3;         ///< %, of what all frequencies share.
    double damping = 30;      ///< %
    double participation = 5; ///< %
    double place = 1;         ///< mm, of each coordinate of each point.
};

/** A device as the responses of a few points say that it is now.
    @param files  as `frf` and `measure` write them
    @throws InputError  as readMeasurement, retune and solveDevice
    [worker] Docs/Theory.md, section 8.7. */
RetunedDevice retuneByFiles (const DeviceDescription&, const std::vector<std::string>& files, const RetuneDeviations&,
                             bool usesCache);

/** The device file. [worker] Docs/FileFormats.md. */
std::string retunedDeviceText (const RetunedDevice&);
} // namespace antinode
