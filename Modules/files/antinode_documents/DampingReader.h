#pragma once

#include <antinode_text/JsonReader.h>

#include <vector>

namespace antinode
{
/** Damping ratios from "damping_ratio" or "quality_factor", of which exactly one is given: one for all modes, or one
   per mode. Q = 1 / (2 xi). @throws InputError [worker] Docs/Theory.md, section 1. */
std::vector<double> readDampingRatios (const JsonObject&);

/** The damping ratio of a single mode. @throws InputError [worker] */
double readDampingRatio (const JsonObject& mode);
} // namespace antinode
