#pragma once

#include <antinode_documents/ExcitationFile.h>
#include <antinode_measurement/SurfaceMeasurement.h>

#include <filesystem>
#include <string>

namespace antinode
{
/** A measurement on disk: its sheet, its points, and a file for each point that is finished. An interrupted measurement
   is resumed where it ended. */
class MeasurementFolder
{
public:
    /** Starts a measurement, or resumes the existing one.
        @param points  N_p x 2, m
        @throws InputError  where the folder holds another measurement or cannot be written [worker] */
    MeasurementFolder (std::filesystem::path, const ExcitationSheet&, const Eigen::MatrixX2d& points);

    /** Whether a point is finished. [worker] */
    bool has (Eigen::Index point) const;

    /** Stores the results at a point. @throws InputError  where it cannot be written [worker] */
    void keep (const SurfaceMeasurement&, Eigen::Index point) const;

    /** Restores a stored point. @throws InputError  if keep did not write it [worker] */
    void restore (SurfaceMeasurement&, Eigen::Index point) const;

private:
    std::filesystem::path pointFile (Eigen::Index point) const;

    std::filesystem::path folder;
};
} // namespace antinode
