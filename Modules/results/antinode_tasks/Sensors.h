#pragma once

#include "Field.h"

#include <antinode_base/Progress.h>
#include <antinode_focus/FocusDescription.h>
#include <antinode_learning/ChooseSensors.h>
#include <antinode_model/Surface.h>
#include <antinode_reports/Report.h>
#include <antinode_structure/DeviceDescription.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

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

inline constexpr TaskText sensorsText {
    "sensors", "Chooses the places where sensors give most information on the modes of a focus",
    "Docs/Theory.md, section 7.8"
};

/** How sensors are chosen. */
struct SensorRequest
{
    FocusDescription focus;
    DeviceDescription device;
    int count = 2;
    int candidates = 1000;                                          ///< About so many places, in square cells.
    double sampleRate = 96000, duration = 0.25, signalToNoise = 40; ///< Hz, s, dB at an average place.
    double frequency = 0.005, damping = 0.1, participation = 0.05;  ///< Standard deviations of the device's modes.
    std::vector<int> idleCeramics; ///< That are not driven and may be among the sensors, counted from 1.
    bool usesCache = true;
};

/** [any] */
std::vector<Field> fields (SensorRequest&);

/** Sensors, and the device that they listen to. */
struct SensorsOnDevice
{
    ModalModel model;
    SensorPlaces places;
};

/** Where sensors tell most of the modes that a focus plays on a device.
    @param progress  may be empty
    @throws InputError, LimitError  as designFocus, or where there are fewer candidates than sensors
    [worker] */
SensorsOnDevice sensors (const SensorRequest&, const ShowProgress& progress);
} // namespace antinode
