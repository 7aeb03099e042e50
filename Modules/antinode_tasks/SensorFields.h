#pragma once

#include "Field.h"

#include <antinode_bench/SensorScale.h>

#include <vector>

namespace antinode
{
/** [any] */
std::vector<Field> fields (SensorScale&);

/** @throws InputError  where there is none [any] */
void requireSensitivity (const SensorScale&);
} // namespace antinode
