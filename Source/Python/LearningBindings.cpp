#include "Keywords.h"
#include "Module.h"
#include "ResultClass.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_learning/LearningPasses.h>
#include <antinode_tasks/Design.h>
#include <antinode_tasks/Follow.h>
#include <antinode_tasks/LearnFiles.h>
#include <antinode_tasks/Sensors.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <iterator>

namespace antinode
{
namespace
{
namespace py = pybind11;
using Path = std::filesystem::path;
constexpr double inPpm = 1e6, inPercent = 100;

Eigen::MatrixX2d chosenPlaces (const SensorsOnDevice& value)
{
    const auto& places = value.places;
    Eigen::MatrixX2d chosen (static_cast<Eigen::Index> (places.choice.chosen.size()), 2);

    for (Eigen::Index i = 0; i < chosen.rows(); ++i)
        chosen.row (i) = sensorPlace (value.model, places, static_cast<std::size_t> (i)).transpose();

    return milli * chosen;
}

std::vector<int> chosenCeramics (const SensorsOnDevice& value)
{
    std::vector<int> ceramics;

    for (std::size_t i = 0; i < value.places.choice.chosen.size(); ++i)
        ceramics.push_back (chosenCeramic (value.places, i));

    return ceramics;
}

void bindSensors (py::module_& module)
{
    using Value = SensorsOnDevice;
    ResultClass<Value> (module, "Sensors",
                        "Places where N sensors give most information. Made by :func:`antinode.sensors`.")
        .isShownAs (
            [] (const Value& value)
            {
                const auto& bits = value.places.choice.bits;
                return "Sensors: " + std::to_string (bits.size()) + " places, " + fixedText (bits.back(), 1) + " bits";
            })
        .has ("places_mm",
              "N x 2: x and y, mm, the most informative place first: ``sensors_mm`` of :func:`antinode.learn`. An idle "
              "ceramic has its middle.",
              &chosenPlaces)
        .has ("idle_ceramics", "N: which ceramic each sensor is, counted from 1; 0: it is a place.", &chosenCeramics)
        .has ("bits", "N: information of the first one, two... of them together, bits.",
              [] (const Value& value)
              {
                  const auto& bits = value.places.choice.bits;
                  return Eigen::VectorXd (Eigen::Map<const Eigen::VectorXd> (bits.data(), std::ssize (bits)));
              })
        .has ("random_bits", "Information of as many sensors at random places, bits: the median.",
              [] (const Value& value) { return value.places.randomBits; })
        .has ("candidates_mm", "N_c x 2: x and y of the places that were compared, mm.",
              [] (const Value& value)
              { return Eigen::MatrixX2d (milli * value.places.cells.centres (value.places.cell, Eigen::all)); })
        .has ("candidate_bits",
              "N_c and more: information of one sensor alone there, then of each idle ceramic, bits. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.places.bits; })
        .has ("numbers", "All of ``summary.json``.",
              [] (const Value& value) { return Json { sensorsToJson (value.model, value.places).dump() }; })
        .saves ("folder",
                "Writes the folder of ``antinode sensors``: ``sensors.csv``, ``candidates.csv``, ``summary.json``, "
                "``report.html``.",
                [] (const Value& value, const Path& folder) { writeSensors (folder, value.model, value.places); })
        .plots ("plot_sensors",
                "Information of one sensor by its place, with the chosen places, as a Matplotlib figure.")
        .reports ([] (const Value& value) { return sensorsReport (value.model, value.places); });
    bindTask<SensorRequest> (module, "sensors", sensorsText, "Sensors", &sensors);
}

/** The design to play from now on, on the learnt device. */
std::shared_ptr<DesignedFocus> learntDesign (const LearntDevice& value)
{
    return std::make_shared<DesignedFocus> (DesignedFocus { { value.learnt.wide, value.learnt.design },
                                                            { Reconstruction::bandLimited, value.settings.sampleRate },
                                                            10,
                                                            {} });
}

/** Of numbers of all modes those of the device's own; there are none before the first play. */
auto ownModes (const LearntDevice& value, const Eigen::VectorXd& numbers)
{
    return numbers.head (std::min (value.setup.nominal.known, numbers.size()));
}

void bindLearnt (py::module_& module)
{
    using Value = LearntDevice;
    const auto part = [] (const char* key)
    { return [key] (const Value& value) { return Json { learntToJson (value.learnt)[key].dump() }; }; };
    ResultClass<Value> (
        module, "Learnt",
        "A focus that was improved by recordings of its plays: N_m modes. Made by :func:`antinode.learn`.")
        .isShownAs (
            [] (const Value& value) {
                return "Learnt '" + value.setup.focus.name + "': " + std::to_string (value.learnt.passes.size())
                       + " plays";
            })
        .has ("design", "What to play from now on; :func:`antinode.render` plays it on the learnt device.",
              &learntDesign, "Design")
        .has ("device", "The learnt device; a drawn one stays one.",
              [] (const Value& value) { return DeviceText { learntDeviceText (value) }; })
        .has ("voltages_V", "N_b x N_s: what to play next, V.",
              [] (const Value& value)
              {
                  return Work (py::none())
                      .run ([&] { return Eigen::MatrixXd (learntOutputs (value.learnt, value.settings).voltages); });
              })
        .has ("passes",
              "The plays in their order: estimated_field_error_percent; surprise_of_noise, not predicted by the model "
              "of that time; surprise_of_noise_nominal, not predicted by the given device; latency_ms, given or found.",
              part ("passes"), "list[dict[str, float]]")
        .has ("ceramics",
              "Results for each ceramic, empty before the first play: name; distortion_percent, its cubic "
              "distortion "
              "at its largest voltage of the last play, above 0 where it moves more than in proportion; "
              "distortion_deviation_percent, its remaining standard deviation.",
              part ("ceramics"), "list[dict[str, Any]]")
        .has ("is_accepted",
              "Whether the learnt modes are used; else ``design`` is one that was played, and ``refusal`` says why.",
              [] (const Value& value) { return value.learnt.refusal.empty(); })
        .has ("refusal", "Why the learnt modes are not used, a sentence; empty if they are.",
              [] (const Value& value) { return value.learnt.refusal; })
        .has ("warning", "Why the used modes may still be wrong, a sentence; empty if no reason is known.",
              [] (const Value& value) { return warningOf (value.learnt); })
        .has ("frequency_deviations",
              "N_m: remaining relative standard deviations of the frequencies. A view; empty before the first play.",
              [] (const Value& value) { return ownModes (value, value.learnt.learnt.frequencyDeviations); })
        .has ("damping_deviations",
              "N_m: remaining relative standard deviations of the damping ratios. A view; empty before the first "
              "play.",
              [] (const Value& value) { return ownModes (value, value.learnt.learnt.dampingDeviations); })
        .has ("numbers", "All of ``summary.json``.",
              [] (const Value& value) { return Json { learntToJson (value.learnt).dump() }; })
        .saves ("folder",
                "Writes the folder of ``antinode learn``: ``voltages.wav``, ``design.json``, ``device.json``, "
                "``learnt.csv``, ``summary.json``, ``report.html``.",
                [] (const Value& value, const Path& folder) { writeLearnt (folder, value); })
        .draws ("png", pictureHelp,
                [] (const Value& value, const PictureStyle& style)
                { return designPicture (*learntDesign (value), style); })
        .plots ("plot_passes", "The estimated field error by pass as a Matplotlib figure.");
    bindTask<LearnRequest> (module, "learn", learnText, "Learnt", &learn);
}

/** One number of each moment. */
template <typename Number>
auto byMoment (const Number& number)
{
    return [number] (const FollowedDevice& value)
    {
        const auto& moments = value.trace.moments;
        Eigen::VectorXd numbers (static_cast<Eigen::Index> (moments.size()));
        std::transform (moments.begin(), moments.end(), numbers.begin(), number);
        return numbers;
    };
}

/** N x N_m: a number of each moment and of each of the device's own modes. */
auto byMode (Eigen::VectorXd DriftMoment::*numbers)
{
    return [numbers] (const FollowedDevice& value)
    {
        const auto& moments = value.trace.moments;
        Eigen::MatrixXd table (static_cast<Eigen::Index> (moments.size()), value.known);

        for (std::size_t i = 0; i < moments.size(); ++i)
            table.row (static_cast<Eigen::Index> (i)) = inPpm * (moments[i].*numbers).head (value.known).transpose();

        return table;
    };
}

auto wordsBy (const std::function<std::string (const DriftMoment&)>& word)
{
    return [word] (const FollowedDevice& value)
    {
        std::vector<std::string> words;
        std::transform (value.trace.moments.begin(), value.trace.moments.end(), std::back_inserter (words), word);
        return words;
    };
}

void bindFollowed (py::module_& module)
{
    using Value = FollowedDevice;
    ResultClass<Value> (module, "Followed",
                        "How a device drifted: N windows of a recording, N_m modes. Made by :func:`antinode.follow`.")
        .isShownAs (
            [] (const Value& value)
            {
                const auto& last = value.trace.moments.back();
                return "Followed: " + std::to_string (std::lround (inPpm * last.common)) + " ppm in the end, "
                       + driftStateWord (last.state);
            })
        .has ("device", "The device at the end; a drawn one stays one.",
              [] (const Value& value) { return DeviceText { driftedDeviceText (value) }; })
        .has ("times_s", "N: the ends of the windows, s from the beginning of the recording.",
              byMoment ([] (const DriftMoment& moment) { return moment.time; }))
        .has ("states",
              "N: 'following'; 'silent', where too little was played; 'lost', where the signals were not explained.",
              wordsBy ([] (const DriftMoment& moment) { return driftStateWord (moment.state); }))
        .has ("reasons", "N: why a window is lost, a sentence; else empty.",
              wordsBy ([] (const DriftMoment& moment) { return moment.reason; }))
        .has ("common_ppm", "N: common deviation of all frequencies from the device, ppm.",
              byMoment ([] (const DriftMoment& moment) { return inPpm * moment.common; }))
        .has ("frequency_changes_ppm", "N x N_m: deviation of each frequency from the device, ppm.",
              byMode (&DriftMoment::frequencies))
        .has ("frequency_deviations_ppm", "N x N_m: standard deviations of these, ppm.",
              byMode (&DriftMoment::deviations))
        .has ("unexplained_percent", "N: part of the signals that the model does not explain beyond the noise, %.",
              byMoment ([] (const DriftMoment& moment) { return inPercent * moment.unexplained; }))
        .has ("jumps_percent", "N: the jump of all frequencies that was found, %; 0: none.",
              byMoment ([] (const DriftMoment& moment) { return inPercent * moment.jump; }))
        .has ("numbers", "All of ``summary.json``.",
              [] (const Value& value) { return Json { driftToJson (value.trace).dump() }; })
        .saves ("folder",
                "Writes the folder of ``antinode follow``: ``drift.csv``, ``device.json``, ``summary.json``, "
                "``report.html``.",
                [] (const Value& value, const Path& folder) { writeDrift (folder, value); })
        .plots ("plot_drift", "The common change of all frequencies over time as a Matplotlib figure.")
        .reports (&driftReport);
    bindTask<FollowRequest> (module, "follow", followText, "Followed", &follow);
}
} // namespace

void bindLearning (py::module_& module)
{
    bindSensors (module);
    bindLearnt (module);
    bindFollowed (module);
}
} // namespace antinode
