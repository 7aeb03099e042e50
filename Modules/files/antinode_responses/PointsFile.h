#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <string>
#include <string_view>

namespace antinode
{
/** Places of a surface from CSV text: lines of x and y, or of x alone on a line, in mm; after a heading line or none.
    Lines, comments and cells as readCsvTable knows them; each line may have a separator of its own.
    @param source  how errors name it
    @return        N x 2: x and y, m
    @throws InputError  source, line, what is wrong, what is allowed
    [worker] Docs/FileFormats.md. */
Eigen::MatrixX2d decodePoints (std::string_view bytes, const std::string& source);

/** The same of a file of at most 16 MiB. @throws InputError  also when it cannot be read [worker] */
Eigen::MatrixX2d readPointsFile (const std::filesystem::path&);
} // namespace antinode
