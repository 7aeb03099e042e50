#pragma once

#include "UniversalFile.h"
#include "UniversalRecords.h"

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

/** The lines of data set 151. [worker] */
UniversalHeader readHeaderSet (UniversalRecords&);

/** The units of data set 164. @throws InputError  source, line, what is wrong [worker] */
UniversalUnits readUnitSet (UniversalRecords&);

/** The records of a set 151 or 164. @throws InputError  when a number is not finite [worker] */
std::string encodeHeaderSet (const UniversalHeader&);
std::string encodeUnitSet (const UniversalUnits&);
} // namespace antinode
