#pragma once

#include "UniversalRecords.h"
#include "UniversalSets.h"

namespace antinode
{
/** Data at nodes of data set 55. @throws InputError  source, line, what is wrong [worker] */
UniversalShape readShapeSet (UniversalRecords&);

/** The records of a set 55. @throws InputError  when a number is not finite [worker] */
std::string encodeShapeSet (const UniversalShape&);
} // namespace antinode
