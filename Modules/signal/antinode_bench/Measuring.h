#pragma once

#include "Bench.h"

#include <Eigen/Core>
#include <antinode_documents/ExcitationFile.h>
#include <antinode_identification/Wiring.h>
#include <antinode_measurement/RunAnalysis.h>
#include <antinode_measurement/SurfaceMeasurement.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

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

/** The user's choice at a point. */
enum class PointAnswer
{
    measure,
    skip,
    again, ///< The previous point.
    end
};

/** How a measurement talks with whoever makes it; what is missing is left out. [worker] calls */
struct PointGuide
{
    /** Asks for the sensors to be put at consecutive points, and waits for the answer; none: everything is measured as
        it comes.
        @param places  N_p x 2, m */
    std::function<PointAnswer (const Eigen::MatrixX2d& places, Eigen::Index first, Eigen::Index count)> ask;

    /** Says how it went, in a line. */
    std::function<void (const std::string& sentence)> tell;

    /** Called before each ceramic is played. */
    std::function<void (Eigen::Index ceramic)> plays;

    /** What is measured so far, and which wires are wrong by it: after the first point and at the end; none: they are
        told. */
    std::function<void (const SurfaceMeasurement&, const std::vector<WireFinding>&)> wires;
};

/** What the level check plays before the first point: a short multisine in the same band at a tenth of the levels.
    [worker] */
Excitation levelCheckExcitation (const ExcitationSheet&);

/** Measures all points that are not kept yet: checks levels first, leads from point to point, keeps each when it is
   finished.
    @param settings  of the analysis; the latency for benches without a sync channel
    @param drawn     says which wires are wrong, after the first point and at the end
    @return          all that is kept and measured; not a number where points were skipped
    @throws InputError  where inputs would clip or receive no signal, the user ends, or the bench cannot play; Cancelled
   where the user interrupts: what is finished is kept [worker] */
SurfaceMeasurement measurePoints (Bench&, const ExcitationSheet&, const Eigen::MatrixX2d& points,
                                  const MeasurementFolder&, const PointGuide&, const RunAnalysisSettings& settings,
                                  const ModalModel& drawn);
} // namespace antinode
