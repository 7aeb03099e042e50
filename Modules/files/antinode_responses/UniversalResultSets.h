#pragma once

#include "UniversalFile.h"
#include "UniversalRecords.h"

namespace antinode
{
/** Analysis data of set 2414. @throws InputError  source, line, what is wrong [worker] */
UniversalResults readResultSet (UniversalRecords&);

/** The records of a set 2414. @throws InputError  when a number is not finite [worker] */
std::string encodeResultSet (const UniversalResults&);

/** Data at nodes of data set 55. @throws InputError  source, line, what is wrong [worker] */
UniversalShape readShapeSet (UniversalRecords&);

/** The records of a set 55. @throws InputError  when a number is not finite [worker] */
std::string encodeShapeSet (const UniversalShape&);
} // namespace antinode
