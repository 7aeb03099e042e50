#pragma once

#include "UniversalRecords.h"
#include "UniversalSets.h"

namespace antinode
{
/** Nodes of data set 15, or 2411 where `isDouble`. @throws InputError  source, line, what is wrong [worker] */
UniversalNodes readNodeSet (UniversalRecords&, bool isDouble);

/** A trace line of data set 82. @throws InputError  source, line, what is wrong [worker] */
UniversalTrace readTraceSet (UniversalRecords&);

/** Elements of data set 2412. @throws InputError  source, line, what is wrong [worker] */
UniversalElements readElementSet (UniversalRecords&);

/** The records of a set 15 or 2411, 82, 2412. @throws InputError  when a number is not finite [worker] */
std::string encodeNodeSet (const UniversalNodes&);
std::string encodeTraceSet (const UniversalTrace&);
std::string encodeElementSet (const UniversalElements&);
} // namespace antinode
