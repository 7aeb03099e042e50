#pragma once

#include <antinode_learning/ChooseSensors.h>
#include <antinode_model/SquareCells.h>
#include <antinode_reports/Report.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace antinode
{
/** Where sensors could be, and where they should be. */
struct SensorPlaces
{
    std::string device, focus;
    SquareCells cells;              ///< Candidates are those whose centre lies on the surface.
    std::vector<Eigen::Index> cell; ///< Of each candidate that is a place.
    std::vector<int> idle;          ///< The candidates after these: ceramics that are not driven, counted from 1.
    Eigen::VectorXd bits;           ///< What a sensor at each candidate tells alone.
    SensorChoice choice;            ///< Indices of candidates.
    double randomBits = 0;          ///< The median of as many sensors at random candidates.
};

/** Writes where to listen: sensors.csv for `learn` and `follow`, candidates.csv, summary.json and report.html.
    @throws InputError  when the folder cannot be written
    [worker] Docs/FileFormats.md. */
void writeSensors (const std::filesystem::path& folder, const ModalModel&, const SensorPlaces&);

/** summary.json of where to listen. [any] Docs/FileFormats.md. */
nlohmann::ordered_json sensorsToJson (const ModalModel&, const SensorPlaces&);

/** report.html of where to listen: what one sensor tells, by its place. [worker] */
ReportPage sensorsReport (const ModalModel&, const SensorPlaces&);

/** Which ceramic a chosen sensor is, counted from 1; 0: a place. @param rank  0: the most informative [any] */
int chosenCeramic (const SensorPlaces&, std::size_t rank);

/** Where a chosen sensor is, m: of a ceramic its middle. [any] */
Eigen::Vector2d sensorPlace (const ModalModel&, const SensorPlaces&, std::size_t rank);
} // namespace antinode
