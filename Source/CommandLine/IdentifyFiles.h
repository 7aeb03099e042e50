#pragma once

#include "IdentifyOptions.h"

#include <antinode_base/ShowProgress.h>
#include <antinode_reports/IdentificationReport.h>
#include <antinode_structure/DeviceDescription.h>

#include <optional>
#include <string>

namespace antinode
{
/** The modes of measured files, as the options ask for them.
    @param against   a computed device to compare with; none: there is none
    @param progress  may be empty
    @throws InputError  for files that cannot be read, options that are not allowed, and where there are no modes
    [worker] Docs/Theory.md, section 8. */
IdentificationResult identifyFiles (const IdentifyOptions&, const std::optional<DeviceDescription>& against,
                                    const ShowProgress& progress);

/** In dB; also that of the measured quantity where it is not a velocity, and of the modes alone, which are all that a
    device has, where residual terms make a difference. [any] */
std::string reconstructionError (const IdentificationResult&);

/** The device file. [worker] Docs/FileFormats.md. */
std::string identifiedDeviceText (const IdentificationResult&);

/** Writes the files that the options name.
    @param hasReport  also a report, and beside it a diagram to pick modes
    @throws InputError  when one cannot be written [worker] */
void writeIdentified (const IdentificationResult&, const IdentifyOptions&, bool hasReport);
} // namespace antinode
