#pragma once

#include "UniversalFile.h"

namespace antinode
{
/** A function of data set 58 or 58b. @throws InputError  source, line, what is wrong [worker] */
UniversalFunction readFunctionSet (const UniversalSection&, const std::string& source);

/** The number line, the records and the data of a function. @throws InputError  when a number is not finite [worker] */
std::string encodeFunctionSet (const UniversalFunction&);
} // namespace antinode
