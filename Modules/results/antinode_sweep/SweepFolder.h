#pragma once

#include "PartFolder.h"
#include "SweepInputs.h"

#include <filesystem>

namespace antinode
{
/** A folder that keeps a plan, as plan.json, with its parts. It is made where it is missing.
    @throws InputError  when it cannot be written or belongs to another plan
    [worker] */
PartFolder sweepFolder (const std::filesystem::path&, const SweepInputs&);
} // namespace antinode
