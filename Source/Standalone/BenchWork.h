#pragma once

#include "HostBench.h"

#include <Editor/NewestQuestion.h>
#include <Editor/SurfaceView.h>
#include <antinode_session/Documents.h>
#include <antinode_tasks/Measure.h>
#include <antinode_tasks/Retune.h>

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** A measurement of a drawn device that the window leads, from the checklist to the retuned device. */
struct BenchQuestion
{
    std::shared_ptr<const DeviceDocument> device;
    OpenBench open;             ///< Called when the places are known. [worker]
    std::function<void()> rest; ///< Called while it waits for an answer: other things may play; none: nothing is done.
    BenchSensor sensor;
    bool hasSync = true;
    double sampleRate = 96000;  ///< Hz
    double latency = 0;         ///< s, without a sync channel.
    double levelShare = 0.2;    ///< Of the limit of each ceramic and its amplifier.
    std::vector<double> limits; ///< V, of each ceramic, that the program keeps besides the device's; missing: none.
    std::vector<int> outputs;   ///< Of each ceramic, counted from 0.
    int syncOutput = -1;        ///< Counted from 0; below 0: none.
    std::string conditions;     ///< Routing and sensor: what was measured under others does not count.
    int points = 6;
    std::filesystem::path folder; ///< In which the measurement gets one of its own.
};

/** Where a measurement is. */
enum class BenchStep
{
    none,
    preparing, ///< Modes, places and the checklist.
    aiming,    ///< Waits for the sensor to be at a point.
    playing,
    wires, ///< Some are wrong: waits for a decision.
    retuning,
    done,
    failed ///< Asked again, it goes on with the next point.
};

/** What there is to show of a measurement. */
struct BenchState
{
    BenchStep step = BenchStep::none;
    std::shared_ptr<const DeviceDocument> device;
    std::shared_ptr<const SurfacePicture> picture;
    Eigen::MatrixX2d points;    ///< N_p x 2, m
    std::vector<bool> measured; ///< N_p
    Eigen::Index point = 0;     ///< Where the sensor is, or is to be.
    Eigen::Index ceramic = -1;  ///< That plays.
    std::string checklist;
    std::vector<double> toneVolts;     ///< N_b: peak of the identify tone, V.
    Eigen::VectorXd answers;           ///< N_b: RMS over all lines at the measured points, (m/s)/V; empty: not yet.
    double latency = 0;                ///< s, of the last run; 0: not known.
    std::vector<WireFinding> findings; ///< After the first point and at the end.
    std::vector<std::string> sentences;
    std::filesystem::path folder;
    std::shared_ptr<const RetunedDevice> retuned;
    double missBefore = 0, missAfter = 0; ///< Of the measured responses, RMS over RMS of magnitudes.
    std::shared_ptr<const Chart> chart;   ///< The strongest response: measured, drawn, retuned.
    std::string error;
};

/** Measures on a thread that runs it, and asks the window where to go on. The window may go before the thread: both
    share it. */
class BenchWork
{
public:
    /** Works until it is stopped. [worker] */
    void run();

    /** Returns at once. [message thread, as all below] */
    void leave();

    void ask (BenchQuestion);

    /** Where it waits for an answer: at a point, or whether to go on with wires that are wrong (measure).
        @param step, point  of the question that is answered: others are not */
    void answer (PointAnswer, BenchStep step, Eigen::Index point);

    /** Ramps to 0 V and ends; what is measured is kept. */
    void stop();

    BenchState state() const;

private:
    void measure (const BenchQuestion&);
    PointGuide guide (const MeasurementFolder&, const std::function<void()>& rest);
    PointAnswer waitForAnswer();
    void retune (const BenchQuestion&, const MeasuredSurface&);
    void set (const std::function<void (BenchState&)>&);

    NewestQuestion<BenchQuestion> questions;
    mutable std::mutex mutex;
    std::condition_variable answered;
    BenchState known;                  ///< Under the mutex, as the next line.
    std::optional<PointAnswer> chosen; ///< None: not yet.
};

/** The text of the retuned device with a name of its own. @throws InputError  as deviceText [worker] */
std::string namedDeviceText (const RetunedDevice&, const std::string& name);

/** A bench for a tour without hardware: a plate off its drawing as usual plates are, with two exchanged wires and a
    reversed one, where there are enough.
    @param routing  by which ceramics are played: what puts the wires right here does so on a real bench
    [any] */
OpenBench simulatedTour (const OutputRouting& routing);
} // namespace antinode
