#pragma once

#include "MatlabFile.h"
#include "RecordedSignals.h"

#include "UniversalSets.h"

namespace antinode
{
/** As decodeRecordings. @throws InputError  where force, motion or time are missing or do not fit together [worker] */
RecordingFile recordingsFromMatlab (const std::vector<MatlabVariable>&, const std::string& source);

/** The same. [worker] */
RecordingFile recordingsFromUniversal (const std::vector<UniversalSet>&, const std::string& source);
} // namespace antinode
