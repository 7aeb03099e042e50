#pragma once

#include <antinode_documents/ExcitationFile.h>
#include <antinode_measurement/SurfaceMeasurement.h>

#include <filesystem>

namespace antinode
{
/** Writes responses.uff and report.html of a measurement into its folder.
    @throws InputError  when they cannot be written [worker] Docs/FileFormats.md. */
void writeMeasured (const std::filesystem::path&, const SurfaceMeasurement&, const ExcitationSheet&);
} // namespace antinode
