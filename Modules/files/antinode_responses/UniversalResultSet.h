#pragma once

#include "UniversalRecords.h"
#include "UniversalSets.h"

namespace antinode
{
/** Analysis data of set 2414. @throws InputError  source, line, what is wrong [worker] */
UniversalResults readResultSet (UniversalRecords&);

/** The records of a set 2414. @throws InputError  when a number is not finite [worker] */
std::string encodeResultSet (const UniversalResults&);
} // namespace antinode
