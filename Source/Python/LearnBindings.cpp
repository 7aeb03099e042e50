#include "ArrayViews.h"
#include "Bindings.h"
#include "Pictures.h"
#include "Places.h"
#include "Recordings.h"
#include "Values.h"
#include "Work.h"

#include <CommandLine/LearnFiles.h>
#include <CommandLine/LearnSetup.h>
#include <antinode_base/InputError.h>

#include <nlohmann/json.hpp>

#include <pybind11/stl.h>

#include <algorithm>

namespace antinode
{
namespace
{
namespace py = pybind11;

/** What was learnt, with what it started from. */
struct LearntValue
{
    LearningSetup setup;
    LearningSettings settings;
    LearntFocus learnt;
};

using Learnt = std::shared_ptr<LearntValue>;

/** Plays by a function of Python: voltages and the number of the pass (from 0) in, the signals of the sensors out. */
PassPlayer playerOf (const py::function& play, const LearnOptions& options)
{
    return [&] (const Eigen::MatrixXd& voltages, int pass)
    {
        const py::gil_scoped_acquire withGil;
        const py::object signals = play (arrayOf (Eigen::MatrixXd (voltages)), pass);
        return withNoiseAndLatency (recordingOf (options.rate, voltages, matrixOf (signals, "play")), options);
    };
}

Learnt learnFrom (const FocusValue& focus, const DeviceValue& device, LearnOptions options, const PlacePairs& sensors,
                  const std::optional<py::function>& play, py::object progress)
{
    Work work (std::move (progress));
    const auto show = work.progress();
    const auto places = placesOf (sensors, "sensors_mm");
    options.isPlayed = play.has_value();

    return work.run (
        [&]
        {
            const auto tell = [&] (double share)
            {
                if (show)
                    show ("Learning", share);
            };
            auto setup = learningSetup (device.description, focus.description, places, options);
            const auto settings = learningSettings (options);
            auto learnt = learnFocus (setup.nominal, setup.focus, setup.sensors, setup.deviations,
                                      play ? undoingLags (playerOf (*play, options), setup, options.rate)
                                           : passesOf (options, setup),
                                      settings, tell);
            return std::make_shared<LearntValue> (LearntValue { std::move (setup), settings, std::move (learnt) });
        });
}

/** The design to play from now on, on the device as it was learnt. */
std::shared_ptr<DesignValue> learntDesign (const LearntValue& value)
{
    constexpr double usualRepetitions = 10; // Per second, as those of designs.
    return std::make_shared<DesignValue> (DesignValue { { value.learnt.wide, value.learnt.design },
                                                        { Reconstruction::bandLimited, value.settings.sampleRate },
                                                        usualRepetitions,
                                                        {} });
}

Eigen::MatrixXd nextVoltages (const LearntValue& value)
{
    return learntOutputs (value.learnt, value.settings).voltages;
}

/** Of numbers of all modes those of the device's own; there are none before the first play. */
auto ownModes (const LearntValue& value, const Eigen::VectorXd& numbers)
{
    return numbers.head (std::min (value.setup.nominal.known, numbers.size()));
}

/** An option that is a part of the bench. */
template <typename Part>
void bindBench (py::class_<LearnOptions>& options, const char* name, Part SimulatedBenchSettings::*part)
{
    options.def_property (
        name, [part] (const LearnOptions& value) { return value.bench.*part; },
        [part] (LearnOptions& value, const Part& given) { value.bench.*part = given; });
}

void bindOptions (py::module_& module)
{
    py::class_<LearnOptions> options (module, "LearnOptions");
    options.def (py::init());
    options.def_readwrite ("idle_ceramics", &LearnOptions::idleCeramics);
    options.def_readwrite ("sample_rate_Hz", &LearnOptions::rate);
    options.def_readwrite ("duration_ms", &LearnOptions::duration);
    options.def_readwrite ("latency_ms", &LearnOptions::latency);
    options.def_readwrite ("longest_latency_ms", &LearnOptions::longestLatency);
    options.def_readwrite ("frequency_percent", &LearnOptions::frequency);
    options.def_readwrite ("damping_percent", &LearnOptions::damping);
    options.def_readwrite ("participation_percent", &LearnOptions::participation);
    options.def_readwrite ("place_mm", &LearnOptions::place);
    options.def_readwrite ("distortion_percent", &LearnOptions::distortion);
    options.def_readwrite ("passes", &LearnOptions::passes);
    options.def_readwrite ("enough_percent", &LearnOptions::enough);
    options.def_readwrite ("simulate", &LearnOptions::isSimulated);
    options.def_readwrite ("recorded", &LearnOptions::recorded);
    options.def_readwrite ("simulated_delay_ms", &LearnOptions::benchDelay);
    options.def_readwrite ("simulated_cubic_percent", &LearnOptions::benchCubic);
    options.def_readwrite ("cache", &LearnOptions::usesCache);
    bindBench (options, "seed", &SimulatedBenchSettings::seed);
    bindBench (options, "snr_dB", &SimulatedBenchSettings::signalToNoise);
    options.def_property (
        "sensor", [] (const LearnOptions& value) { return value.audio.sensor; },
        [] (LearnOptions& value, const SensorOptions& scale) { value.audio.sensor = scale; });
}
} // namespace

void bindLearn (py::module_& module)
{
    bindOptions (module);
    py::class_<LearntValue, Learnt> bound (module, "Learnt");
    bound.def_static ("make", &learnFrom);
    bound.def_property_readonly ("numbers",
                                 [] (const LearntValue& value) { return learntToJson (value.learnt).dump(); });
    bound.def_property_readonly ("device", [] (const LearntValue& value)
                                 { return learntDeviceText (value.setup, value.learnt); });
    bound.def_property_readonly ("design", &learntDesign);
    bound.def ("voltages_V", [] (const LearntValue& value)
               { return arrayOf (Work (py::none()).run ([&] { return nextVoltages (value); })); });
    bound.def_property_readonly (
        "frequency_deviations",
        viewProperty<LearntValue> ([] (const LearntValue& value)
                                   { return ownModes (value, value.learnt.learnt.frequencyDeviations); }));
    bound.def_property_readonly (
        "damping_deviations",
        viewProperty<LearntValue> ([] (const LearntValue& value)
                                   { return ownModes (value, value.learnt.learnt.dampingDeviations); }));
    bound.def ("save", [] (const LearntValue& value, const std::string& folder)
               { workAway ([&] { writeLearnt (folder, value.setup, value.learnt, value.settings); }); });
}
} // namespace antinode
