#pragma once

#include "ExcitationFile.h"

#include <antinode_text/OutputFolder.h>

#include <filesystem>

namespace antinode
{
/** Writes the sheet and the signal of a run into a folder, as excitation.json and signal.wav. @throws InputError
    [worker] */
void writeSheet (OutputFolder&, const ExcitationSheet&);

/** A sheet with the signal beside it. @throws InputError  for anything that cannot be read. [worker] */
ExcitationSheet readSheet (const std::filesystem::path&);
} // namespace antinode
