#pragma once

#include <Eigen/Core>

#include <filesystem>

namespace antinode
{
/** Places of a surface from a CSV file of at most 16 MiB, in the order in which they are measured: that of their numbers, or of the file
    where they have none. As placesFromCsv otherwise.
    @return  N x 2: x and y, m
    @throws InputError  source, line, what is wrong, what is allowed, or where it cannot be read
    [worker] Docs/FileFormats.md. */
Eigen::MatrixX2d readPointsFile (const std::filesystem::path&);
} // namespace antinode
