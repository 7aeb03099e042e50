#include "RouterRig.h"
#include "Support/EditorTools.h"
#include "Support/TemporaryFolder.h"

#include <Standalone/MainWindow.h>
#include <antinode_base/InputError.h>
#include <antinode_documents/DeviceFile.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <deque>
#include <functional>
#include <set>
#include <string>
#include <thread>

using namespace antinode;
using namespace std::string_literals;

// The bench of the window: a tour that plays nothing, and the ceramics that it drives through the program's outputs.
namespace
{
/** Until something is so; the tests' own limit of time ends what never is. */
void waitFor (const std::function<bool()>& isSo)
{
    while (! isSo())
        std::this_thread::sleep_for (std::chrono::milliseconds (2));
}

WireFinding exchanged (Eigen::Index output, Eigen::Index ceramic)
{
    return { WireFinding::Kind::exchanged, output, ceramic, 0 };
}

/** A window on its tour, with the embedded device that is loaded at first. */
struct TourWindow
{
    TourWindow()
    {
        bench.folder = folder.path();
        host.processor().session().waitUntilSettled();
    }

    void until (BenchStep step)
    {
        waitFor (
            [&]
            {
                bench.refresh();
                INFO (bench.shown().error);
                REQUIRE ((bench.shown().step != BenchStep::failed || step == BenchStep::failed));
                return bench.shown().step == step;
            });
    }

    /** Measures where the cross is, until another point or step comes. */
    void measureHere()
    {
        const auto point = bench.shown().point;
        bench.answer (PointAnswer::measure);
        waitFor (
            [&]
            {
                bench.refresh();
                const auto& now = bench.shown();
                return now.step == BenchStep::failed || now.step == BenchStep::wires || now.step == BenchStep::done
                       || (now.step == BenchStep::aiming && now.point != point);
            });
    }

    const TemporaryFolder folder;
    StandaloneHost host { SettingsFile ({}), false };
    MainComponent window { host };
    BenchPanel& bench = window.benchPanel();
};
} // namespace

TEST_CASE ("the tour finds its wrong wires, puts them right, measures six points and keeps a device by its name")
{
    TourWindow tour;
    auto& bench = tour.bench;
    bench.begin();
    tour.until (BenchStep::aiming);
    REQUIRE (bench.shown().points.rows() == 6);
    CHECK (bench.shown().checklist.find ("1. Connect") != std::string::npos);
    tour.measureHere();
    REQUIRE (bench.shown().step == BenchStep::wires);
    std::set<std::pair<Eigen::Index, WireFinding::Kind>> found;

    for (const auto& each : bench.shown().findings)
        found.emplace (each.output, each.kind);

    const auto last = static_cast<Eigen::Index> (bench.shown().answers.size()) - 1;
    CHECK (found
           == std::set<std::pair<Eigen::Index, WireFinding::Kind>> { { 0, WireFinding::Kind::exchanged },
                                                                     { 1, WireFinding::Kind::exchanged },
                                                                     { last, WireFinding::Kind::reversed } });
    const auto before = tour.host.settings().routing;
    bench.correctRouting();
    CHECK (tour.host.settings().routing == before); // A tour changes no real output.
    tour.until (BenchStep::aiming);
    CHECK (bench.shown().point == 0);

    for (int p = 0; p < 6; ++p)
    {
        CHECK (bench.shown().point == p);
        tour.measureHere();
        CHECK (bench.shown().findings.empty());
    }

    tour.until (BenchStep::done);
    const auto& state = bench.shown();
    CHECK (state.missAfter < 0.1);
    CHECK (state.missBefore > 5 * state.missAfter);
    CHECK (state.latency == Approx (SimulatedBenchSettings().delay).epsilon (1e-3));
    CHECK (std::filesystem::exists (state.folder / "report.html"));

    const auto focus = tour.host.processor().focus();
    bench.save ("my plate");
    tour.host.processor().session().waitUntilSettled();
    const auto file = tour.folder.path() / "my plate.json";
    REQUIRE (std::filesystem::exists (file));
    const auto kept = readDevice (loadDocument (LibraryKind::device, file.string()), file.string());
    CHECK (solveDevice (kept, {}, true).name == "my plate");
    CHECK (tour.host.processor().device()->text.find ("my plate") != std::string::npos);
    CHECK (sayTheSame (*tour.host.processor().focus(), *focus));
    CHECK_FALSE (tour.host.arm().get());
}

TEST_CASE ("a measurement that was stopped goes on with the points that are left, and its folder is never another's")
{
    TourWindow tour;
    auto& bench = tour.bench;
    bench.begin();
    tour.until (BenchStep::aiming);
    tour.measureHere();
    bench.correctRouting();
    tour.until (BenchStep::aiming);
    tour.measureHere();
    const auto folder = bench.shown().folder;
    bench.stop();
    CHECK (bench.shown().step == BenchStep::none);
    bench.begin();
    tour.until (BenchStep::aiming);
    CHECK (bench.shown().folder == folder);
    CHECK (bench.shown().point == 1);
    CHECK (bench.shown().measured[0]);
    CHECK_FALSE (bench.shown().measured[1]);
    bench.stop();

    test::forEachShown (bench,
                        [] (juce::Component& child)
                        {
                            if (auto* const editor = dynamic_cast<juce::TextEditor*> (&child);
                                editor != nullptr && editor->getText() == "20")
                                editor->setText ("10");
                        });

    bench.begin();
    tour.until (BenchStep::aiming);
    CHECK (bench.shown().folder != folder); // Another level is another measurement.

    // What was chosen for one device is not played on another one.
    tour.window.fociEditor()->content().changeDevice (deviceDocument ("beam"));
    bench.answer (PointAnswer::measure);
    CHECK (bench.shown().step == BenchStep::aiming);
    CHECK (bench.shown().sentences.empty());
}

TEST_CASE ("exchanged and reversed wires are put right by the routing")
{
    auto routing = straightRouting();
    const auto right =
        withRightWires (routing, { exchanged (0, 1), exchanged (1, 0), { WireFinding::Kind::reversed, 3, 3, 0 } });
    CHECK (right.outputs[0] == 1);
    CHECK (right.outputs[1] == 0);
    CHECK (right.outputs[2] == 2);
    CHECK (right.chains[3].polarity == -1);
    CHECK (withRightWires (right, { exchanged (0, 1), exchanged (1, 0), { WireFinding::Kind::reversed, 3, 3, 0 } })
           == routing);

    // Output 1 answers as ceramic 3, of whose own output nobody knows anything: it takes the one that is left.
    const auto half = withRightWires (routing, { exchanged (0, 2), { WireFinding::Kind::dead, 2, 2, -40 } });
    CHECK (half.outputs[2] == 0);
    CHECK (half.outputs[0] == 2);
    validate (half);
    validate (withRightWires (routing, { exchanged (0, 1), exchanged (1, 2), exchanged (2, 0) }));
}

TEST_CASE ("a meter's reading says what is wrong with a wire, and a scope's sets the volts at full scale")
{
    CHECK (capacitanceInWords (100e-9, 110e-9) == "as drawn");
    CHECK (capacitanceInWords (100e-9, 45e-9).startsWith ("half"));
    CHECK (capacitanceInWords (100e-9, 210e-9).startsWith ("double"));
    CHECK (capacitanceInWords (100e-9, 2e-9).startsWith ("broken"));

    TourWindow tour;
    tour.bench.begin();
    tour.until (BenchStep::aiming);
    const auto volts = tour.bench.shown().toneVolts.front();
    tour.bench.row (0).enterTone (juce::String (0.9 * volts, 4) + " V");
    tour.until (BenchStep::aiming); // It is measured by the new gain.
    const auto full = tour.bench.shown().picture->model->fullScaleVoltage;
    CHECK (tour.bench.routing().chains[0].voltsPerFullScale == Approx (0.9 * full).epsilon (1e-3));
    tour.bench.row (0).enterTone ("0.0001"); // No gain: a reading of nothing.
    CHECK (tour.bench.routing().chains[0].voltsPerFullScale == Approx (0.9 * full).epsilon (1e-3));
}

namespace
{
/** An audio device of the program, called by a thread of its own: its first input hears all outputs together 100
   samples later, its second the last output. */
struct LoopedDevice
{
    static constexpr int outputs = 10, block = 512, delay = 600; // Longer than two ramps.
    static constexpr double rate = 48000;

    LoopedDevice()
    {
        auto& parameters = host.processor().parameters();
        parameters.find ("notes")->setValueNotifyingHost (1);
        auto routing = withMarker (straightRouting(), { outputs - 1, 1.0, 0.005 });
        host.setRouting (routing);
        juce::BigInteger open, heard;
        open.setRange (0, outputs, true);
        heard.setRange (0, 2, true);
        host.callback().prepare (rate, block, open, heard);
        host.processor().session().waitUntilSettled();
        parameters.arm().setValueNotifyingHost (1);
        caller = std::thread ([this] { call(); });
    }

    ~LoopedDevice()
    {
        isOver = true;
        caller.join();
    }

    void call()
    {
        std::array<std::deque<float>, 2> late { std::deque<float> (delay, 0.0F), std::deque<float> (delay, 0.0F) };

        while (! isOver)
        {
            std::array<std::array<float, block>, 2> in {};
            std::array<std::array<float, block>, outputs> out {};
            std::array<const float*, 2> inputs { in[0].data(), in[1].data() };
            std::array<float*, outputs> to {};
            std::transform (out.begin(), out.end(), to.begin(), [] (auto& each) { return each.data(); });

            for (std::size_t i = 0; i < 2; ++i)
                for (auto& sample : in[i])
                {
                    sample = late[i].front();
                    late[i].pop_front();
                }

            host.callback().audioDeviceIOCallbackWithContext (inputs.data(), 2, to.data(), outputs, block, {});
            double peak = 0;

            for (std::size_t n = 0; n < block; ++n)
            {
                float sum = 0;

                for (std::size_t k = 0; k + 1 < outputs; ++k)
                {
                    sum += out[k][n];
                    peak = std::max (peak, std::abs (static_cast<double> (out[k][n])));
                }

                late[0].push_back (sum / 4);
                late[1].push_back (out[outputs - 1][n]);
            }

            largest = std::max (largest.load(), peak);
            now = peak;

            while (holds && peak > 0 && ! isOver)
                std::this_thread::sleep_for (std::chrono::milliseconds (1));
        }
    }

    Excitation excitation (double seconds)
    {
        ExcitationSettings settings;
        settings.sampleRate = rate;
        settings.lowestFrequency = 100;
        settings.highestFrequency = 4000;
        settings.resolution = 1 / seconds;
        settings.periods = 2;
        settings.settlingPeriods = 1;
        settings.levels = Eigen::VectorXd::Constant (8, 10);
        return makeExcitation (settings, Eigen::VectorXd::Constant (8, 100));
    }

    std::unique_ptr<HostBench> open()
    {
        shared = std::make_shared<BenchDevice> (host);
        return std::make_unique<HostBench> (shared, BenchSensor { 0, 1, { 1000, 1 } }, true, *host.model());
    }

    StandaloneHost host { SettingsFile ({}), false };
    std::shared_ptr<BenchDevice> shared;
    std::atomic<bool> isOver { false };
    std::atomic<bool> holds { false }; ///< It calls no more once an output moves.
    std::atomic<double> largest { 0 }, now { 0 };
    std::thread caller;
};
} // namespace

TEST_CASE ("what the bench plays leaves by the outputs of the ceramics and comes back by the sensor's input")
{
    LoopedDevice device;
    const auto bench = device.open();
    const auto excitation = device.excitation (0.05);
    auto routing = device.host.settings().routing;
    routing.chains[2].voltsPerFullScale = device.host.model()->fullScaleVoltage / 2;
    routing.chains[2].polarity = -1;
    device.host.setRouting (routing);
    const auto straight = analyseRun (excitation, 1, bench->play (excitation, 1, 0, 1));
    const auto other = analyseRun (excitation, 2, bench->play (excitation, 2, 0, 1));
    CHECK (straight.latency == Approx (LoopedDevice::delay).margin (0.01));
    // The same volts where the device that is loaded meanwhile has another full scale.
    auto larger = *device.host.model();
    larger.fullScaleVoltage *= 2;
    HostBench elsewhere (std::make_shared<BenchDevice> (device.host), { 0, 1, { 1000, 1 } }, true, larger);
    const auto same = analyseRun (excitation, 2, elsewhere.play (excitation, 2, 0, 1));
    CHECK ((same.responses.values - other.responses.values).cwiseAbs().maxCoeff()
           < 1e-4 * other.responses.values.cwiseAbs().maxCoeff());
    // A sample of 1 is so many volts, a quarter comes back, and a sample of 1 is 1 m/s.
    const auto gain = 0.25 / device.host.model()->fullScaleVoltage;

    for (Eigen::Index line = 0; line < straight.responses.values.rows(); ++line)
    {
        CHECK (std::abs (straight.responses.values (line, 0) / gain - 1.0) < 1e-3);
        // An amplifier of half the volts is given twice the sample; its wires are swapped.
        CHECK (std::abs (other.responses.values (line, 0) / gain + 2.0) < 2e-3);
    }
}

TEST_CASE ("the bench stops at 0 V by every stop there is, says why, and plays nothing while it may not")
{
    struct Stop
    {
        std::string says;
        std::function<void (LoopedDevice&)> stop, undo;
    };
    const std::vector<Stop> stops {
        { "muted", [] (auto& d) { d.host.muteAll(); }, [] (auto& d) { d.host.router().release(); } },
        { "not armed", [] (auto& d) { d.host.arm().setValueNotifyingHost (0); },
          [] (auto& d) { d.host.arm().setValueNotifyingHost (1); } },
        { "stopped", [] (auto& d) { d.host.stopAll(); }, [] (auto&) {} },
        { "stopped", [] (auto& d) { d.host.setRouting (withOutput (d.host.settings().routing, 1, 5)); },
          [] (auto&) {} },
    };

    for (const auto& [says, stop, undo] : stops)
    {
        LoopedDevice device;
        const auto bench = device.open();
        const auto excitation = device.excitation (1);
        device.holds = true;
        std::string said;
        std::thread worker (
            [&]
            {
                try
                {
                    bench->play (excitation, 1, 0, 1);
                }
                catch (const InputError& failure)
                {
                    said = failure.what();
                }
            });
        waitFor ([&] { return device.now > 0; });
        stop (device);
        device.holds = false;
        worker.join();
        INFO (said);
        CHECK (said.find (says) != std::string::npos);
        const auto samples = device.host.callback().samplesPlayed();
        waitFor ([&] { return device.host.callback().samplesPlayed() > samples + 2000; });
        CHECK (device.now == 0);

        undo (device);
        device.shared->allow(); // As the next answer does.
        CHECK_NOTHROW (bench->play (device.excitation (0.05), 1, 0, 1));
    }

    LoopedDevice device;
    device.host.arm().setValueNotifyingHost (0);
    CHECK_THROWS_WITH (device.open()->play (device.excitation (0.05), 1, 0, 1),
                       Catch::Matchers::Contains ("not armed"));
    CHECK (device.largest == 0);
}

TEST_CASE ("a stop between two ceramics voids what follows, and another rate is refused")
{
    LoopedDevice device;
    const auto bench = device.open();
    const auto excitation = device.excitation (0.05);
    CHECK_NOTHROW (bench->play (excitation, 0, 0, 1));
    device.host.stopAll();
    device.largest = 0;
    CHECK_THROWS_WITH (bench->play (excitation, 1, 0, 1), Catch::Matchers::Contains ("stopped"));
    CHECK (device.largest == 0);
    device.shared->allow();
    auto faster = excitation;
    faster.settings.sampleRate *= 2;
    CHECK_THROWS_WITH (bench->play (faster, 1, 0, 1), Catch::Matchers::Contains ("48000"));
    CHECK (device.largest == 0);
}

TEST_CASE ("a bench whose window has gone ends its run at 0 V")
{
    LoopedDevice device;
    const auto shared = std::make_shared<BenchDevice> (device.host);
    HostBench bench (shared, { 0, 1, { 1000, 1 } }, true, *device.host.model());
    const auto excitation = device.excitation (1);
    device.holds = true;
    std::atomic<bool> goesOn { true };
    bool isCancelled = false;
    std::thread worker (
        [&]
        {
            const WatchScope scope ([&] { return goesOn.load(); });

            try
            {
                bench.play (excitation, 1, 0, 1);
            }
            catch (const Cancelled&)
            {
                isCancelled = true;
            }
        });
    waitFor ([&] { return device.now > 0; });
    goesOn = false;
    shared->close();
    device.holds = false;
    worker.join();
    CHECK (isCancelled);
    const auto samples = device.host.callback().samplesPlayed();
    waitFor ([&] { return device.host.callback().samplesPlayed() > samples + 2000; });
    CHECK (device.now == 0);
}
