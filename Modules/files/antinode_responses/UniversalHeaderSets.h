#pragma once

#include "UniversalRecords.h"
#include "UniversalSets.h"

namespace antinode
{
/** The lines of data set 151. [worker] */
UniversalHeader readHeaderSet (UniversalRecords&);

/** The units of data set 164. @throws InputError  source, line, what is wrong [worker] */
UniversalUnits readUnitSet (UniversalRecords&);

/** The records of a set 151 or 164. @throws InputError  when a number is not finite [worker] */
std::string encodeHeaderSet (const UniversalHeader&);
std::string encodeUnitSet (const UniversalUnits&);
} // namespace antinode
