#include "PlayedSession.h"

#include <Support/LaggingDevice.h>

#include <antinode_engine/LagFilters.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/SpillOver.h>

#include <catch2/catch.hpp>

#include <array>
#include <chrono>
#include <thread>

using namespace antinode;

namespace
{
constexpr double rate = 48000;
constexpr FocusEvent spotPlayed { 0, FocusEventKind::trigger, 60, 1 };

/** Up to a minute: to solve the glass plate alone takes 8 s of the processor. */
bool waitFor (const std::function<bool()>& condition)
{
    for (int i = 0; i < 12000; ++i)
    {
        if (condition())
            return true;

        std::this_thread::sleep_for (std::chrono::milliseconds (5));
    }

    return false;
}
} // namespace

TEST_CASE ("A parameter that moves makes a new design, by itself", "[session]")
{
    test::PlayedSession played;
    played.prepare (rate);
    const auto before = played.play (2400, { spotPlayed });
    played.play (4800);
    played.change ([] (PlaySettings& settings) { settings.peakVelocityMillimetresPerSecond = 20; });
    CHECK (waitFor ([&] { return played.session.snapshot()->focus.targets.front().peakVelocity == 0.02; }));
    const FocusEvent events[] = { spotPlayed };
    played.session.waitUntilSettled (events);
    const auto after = played.play (2400, { spotPlayed });
    CHECK ((after.topRows (8) * 2 - before.topRows (8)).cwiseAbs().maxCoeff() < 1e-3 * before.cwiseAbs().maxCoeff());
}

TEST_CASE ("Free waveforms are a method as any other: played as rendered, never beyond the limit", "[session][sampled]")
{
    const RetiredMethod* const retired = GENERATE (static_cast<const RetiredMethod*> (nullptr), &retiredMethods.back());
    test::PlayedSession played;
    played.change (
        [retired] (PlaySettings& settings)
        {
            settings.method = AllocationMethod::leastVoltage;
            settings.retired = retired;
            settings.voltageLimitVolts = 3;
        });
    played.prepare (rate);
    const auto now = played.session.snapshot();
    REQUIRE (now->focus.allocation.isUpToLimits() == (retired != nullptr));
    const auto wide =
        solveWide (test::deviceNamed ("staple").description, *now->model, frequencyBeyond (*now->model, rate), true);
    const auto design = designWithin (wide, now->focus, now->playback, DesignExtent::playable);
    RenderSettings settings;
    settings.playback = now->playback;
    settings.duration = 0.05;
    settings.probeShapes.resize (0, now->model->modes());
    const auto rendered = renderOffline (*now->model, design.program, settings);
    const auto volts = [&] (const Eigen::MatrixXd& output) -> Eigen::MatrixXd
    { return now->model->fullScaleVoltage * output.topRows (8); };
    const auto alone = volts (played.play (2400, { spotPlayed }));
    CHECK ((alone - rendered.voltages.leftCols (2400)).cwiseAbs().maxCoeff()
           < 1e-6 * rendered.voltages.cwiseAbs().maxCoeff());

    // Two at once would need twice as much.
    PlayControls controls;
    controls.voltageLimit = 3;
    const auto both = volts (played.play (2400, { spotPlayed, spotPlayed }, controls));
    CHECK (both.cwiseAbs().maxCoeff() <= 3 * (1 + 1e-12));
    CHECK (both.cwiseAbs().maxCoeff() > 2.99);
}

TEST_CASE ("Where ceramics lag, outputs are what files get, and come later by what the latency counts",
           "[session][lag]")
{
    const auto lagging = test::withOwnLags (solveDevice (test::deviceNamed ("staple").description, {}, true));
    test::PlayedSession played (test::documentOf (lagging), test::focusNamed ("demonstrator"));
    played.change ([] (PlaySettings& settings) { settings.focusOnNote = true; });
    played.prepare (rate);
    const auto now = played.session.snapshot();
    const auto design = designFocus (*now->model, now->focus, now->playback);
    const auto rendered = renderOffline (*now->model, design.program,
                                         { now->playback, 0.05, 512, Eigen::MatrixXd (0, now->model->modes()) });
    const auto asked = withLagsUndone (*now->model, rendered.voltages, design.program.voltageLimits, rate);
    const Eigen::MatrixXd outputs = now->model->fullScaleVoltage * played.play (2400, { spotPlayed }).topRows (8);
    CHECK ((outputs - asked.voltages.leftCols (2400)).cwiseAbs().maxCoeff()
           < 1e-6 * asked.voltages.cwiseAbs().maxCoeff());
    CHECK (asked.lateness > 0);
    CHECK (played.session.latencySamples() == rendered.focusSample + asked.lateness);

    PlayControls controls;
    controls.isArmed = false;
    played.play (2400, { spotPlayed }, controls);
    CHECK (played.play (480, {}, controls).topRows (8).isZero (0));
    controls = {};
    controls.voltageLimit = 1;
    CHECK (
        (now->model->fullScaleVoltage * played.play (2400, { spotPlayed }, controls).topRows (8)).cwiseAbs().maxCoeff()
        <= 1 + 1e-12);
}

TEST_CASE ("Notes that are wanted first play before the bank is designed", "[session]")
{
    test::PlayedSession played ("glass-148x210", "glass-finger");
    played.session.designFirst ({ 20, 90 });
    played.session.prepare (rate);
    REQUIRE (waitFor ([&] { return played.session.progress().hasFirst; }));
    CHECK_FALSE (played.session.progress().isDone());

    for (const auto note : { 20, 90 })
        CHECK (played.play (9600, { { 0, FocusEventKind::trigger, note, 1 } }).topRows (8).cwiseAbs().maxCoeff() > 0);
}

TEST_CASE ("Another device ramps the old voltages to 0 before its own begin", "[session]")
{
    test::PlayedSession played;
    played.prepare (rate);
    played.play (600, { spotPlayed });
    played.session.load (std::make_shared<const DeviceDocument> (test::deviceNamed ("beam")),
                         std::make_shared<const FocusDocument> (test::focusNamed ("demonstrator")));
    played.session.waitUntilSettled();
    const auto leaving = played.play (960);
    double largestStep = 0;

    for (Eigen::Index n = 1; n < leaving.cols(); ++n)
        largestStep = std::max (largestStep, (leaving.col (n) - leaving.col (n - 1)).head (8).cwiseAbs().maxCoeff());

    CHECK (leaving.leftCols (64).topRows (8).cwiseAbs().maxCoeff() > 0.001);
    CHECK (leaving.rightCols (300).topRows (8).isZero (0));
    CHECK (largestStep < 0.1);
    CHECK (played.session.snapshot()->model->actuators() == 6);
    const std::array events { spotPlayed };
    played.session.waitUntilSettled (events);
    const auto next = played.play (2400, { spotPlayed });
    CHECK (next.middleRows (6, 2).isZero (0));
    CHECK (next.topRows (6).cwiseAbs().maxCoeff() > 0.001);
}

TEST_CASE ("Notes wait while another path takes over, and play as they would have", "[session]")
{
    test::PlayedSession played, changed;
    played.prepare (rate);
    changed.prepare (rate);
    const auto expected = played.play (2400, { spotPlayed });
    changed.play (64, {}); // A path that has played ramps out.
    changed.session.setGraphOpen (true);
    const std::array events { spotPlayed };
    changed.session.waitUntilSettled (events);
    const auto waited = changed.play (4800, { spotPlayed });
    Eigen::Index first = 0;

    while (first < 2400 && waited.col (first).head (8).isZero (0))
        ++first;

    Eigen::Index begin = 0;

    while (expected.col (begin).head (8).isZero (0))
        ++begin;

    const auto late = first - begin; // The ramp, in blocks of 64 samples.
    CHECK (late >= 480);
    CHECK (late <= 480 + 3 * 64);
    CHECK (late % 64 == 0);
    CHECK ((waited.middleCols (late, 2400) - expected).topRows (8).cwiseAbs().maxCoeff()
           < 1e-6 * expected.topRows (8).cwiseAbs().maxCoeff());
}

TEST_CASE ("What notes do changes at once, without another path", "[session]")
{
    test::PlayedSession played;
    played.prepare (rate);
    const auto overlapping = played.play (4800, { spotPlayed, spotPlayed });
    PlayControls controls;
    controls.notes.retrigger = RetriggerBehaviour::restart;
    const auto restarted = played.play (4800, { spotPlayed, spotPlayed }, controls);
    CHECK (restarted.topRows (8).cwiseAbs().maxCoeff()
           == Approx (overlapping.topRows (8).cwiseAbs().maxCoeff() / 2).epsilon (1e-6));
    controls.notes.noteOff = NoteOffBehaviour::fade;
    const auto faded =
        played.play (4800, { spotPlayed, { 10, FocusEventKind::release, Session::spotNote, 0 } }, controls);
    CHECK (faded.topRows (8).rightCols (4800 - 10 - 96).isZero (0));
    CHECK (played.play (4800, { spotPlayed }).topRows (8).cwiseAbs().maxCoeff()
           == Approx (restarted.topRows (8).cwiseAbs().maxCoeff()).epsilon (1e-6));
}

TEST_CASE ("A device that cannot be solved leaves the old one playing, and says why", "[session]")
{
    test::PlayedSession played;
    played.prepare (rate);
    const auto before = played.play (2400, { spotPlayed });
    auto json = loadDocument (LibraryKind::device, "beam");
    json["ceramics"] = nlohmann::json::array();
    played.session.load (std::make_shared<const DeviceDocument> (readDeviceDocument (json, "beam")), nullptr);
    played.session.waitUntilSettled();
    CHECK (played.session.snapshot()->error == "device 'beam': has no ceramics, so nothing can move it");
    played.play (9600);
    CHECK (played.play (2400, { spotPlayed }).topRows (8).isApprox (before.topRows (8)));
}

TEST_CASE ("While another device is solved with other amplifiers, what is said stays that of the one that plays",
           "[session]")
{
    const auto device = test::deviceNamed ("staple");
    const auto focus = test::focusNamed ("demonstrator");
    const auto settings = settingsFromFocus (focus.description, deviceExtent (device.description), {});
    std::atomic<Session*> asked { nullptr };
    std::atomic<int> othersSaid { 0 }, forgotten { 0 }, solvings { 0 };
    const auto look = [&]
    {
        auto* const session = asked.load();

        if (session == nullptr)
            return;

        const auto now = session->snapshot();

        // Both come with the next round: a device, and limits.
        if (now->isSolving && ++solvings == 1)
        {
            session->setAmplifiers (std::vector<double> (8, 60));
            session->load (std::make_shared<const DeviceDocument> (test::deviceNamed ("beam")), nullptr);
        }

        // Of the tail that hosts are told of.
        forgotten += now->isSolving && solvings == 1 && ! (session->progress().endSeconds > 0) ? 1 : 0;
        othersSaid += ! now->isSolving && now->model->name != now->device->description.name ? 1 : 0;
    };
    SessionThread<Session> session (
        device, focus, [&] { return settings; }, look);
    session->prepare (rate);
    session->waitUntilSettled();
    REQUIRE (session->progress().endSeconds > 0);
    asked = &*session;
    session->load (std::make_shared<const DeviceDocument> (test::deviceNamed ("phone")), nullptr);
    session->waitUntilSettled();
    session->waitUntilSettled();
    CHECK (session->snapshot()->device->description.name == "beam");
    CHECK (solvings >= 2);
    CHECK (forgotten == 0);
    CHECK (othersSaid == 0);
    CHECK (voltageLimits (*session->snapshot()->model).maxCoeff() <= 60);
}

TEST_CASE ("A touch is designed at its own place and fired, a place off the surface is not", "[session]")
{
    test::PlayedSession played;
    played.prepare (rate);
    CHECK (played.session.fireAt (1, 0, 1) == Session::FireResult::outsideSurface);
    REQUIRE (played.session.fireAt (-0.02, 0, 0.5) == Session::FireResult::taken);
    CHECK (waitFor (
        [&]
        {
            played.play (64);
            return played.session.meters().triggered() == 1;
        }));
    const auto touched = played.play (2400);
    CHECK (touched.topRows (8).cwiseAbs().maxCoeff() > 0.001);
    played.session.stopAll();
    CHECK (played.play (480).rightCols (300).topRows (8).isZero (0));
}

TEST_CASE ("Fire plays the focus at its own place with the next block", "[session]")
{
    test::PlayedSession played;
    played.prepare (rate);
    const auto byNote = played.play (2400, { spotPlayed });
    played.play (9600);
    played.session.fire (1);
    CHECK (played.play (2400).topRows (8).isApprox (byNote.topRows (8)));
}

TEST_CASE ("No voltage is beyond the limit of the parameters, whatever overlaps", "[session]")
{
    test::PlayedSession played;
    played.prepare (rate);
    PlayControls controls;
    controls.voltageLimit = 15;
    const auto many = played.play (4800, std::vector<FocusEvent> (8, spotPlayed), controls);
    CHECK (many.topRows (8).cwiseAbs().maxCoeff() == Approx (15.0 / 150));
    CHECK (played.session.meters().limitedSamples (0) + played.session.meters().limitedSamples (3) > 0);
}

TEST_CASE ("Meters tell the peak in volts once", "[session]")
{
    test::PlayedSession played;
    played.prepare (rate);
    const auto voltages = played.play (2400, { spotPlayed });
    CHECK (played.session.meters().takePeak (2)
           == Approx (voltages.row (2).cwiseAbs().maxCoeff() * 150).epsilon (1e-5));
    CHECK (played.session.meters().takePeak (2) == 0);
    CHECK (played.session.probeTrace().newest (100).size() == 100);
}

TEST_CASE ("Opened, a session plays the same samples, and nodes of one's own stand in its path", "[session]")
{
    test::PlayedSession played;
    played.prepare (rate);
    const auto fused = played.play (2400, { spotPlayed });
    played.play (9600);
    played.session.setGraphOpen (true);
    CHECK (played.session.isGraphOpen());
    played.session.waitUntilSettled (std::array { spotPlayed });
    played.play (960); // The fused path ramps out.
    const auto opened = played.play (2400, { spotPlayed });
    CHECK (fused.cwiseAbs().maxCoeff() > 0.01);
    CHECK ((opened - fused).cwiseAbs().maxCoeff() < 1e-12 * fused.cwiseAbs().maxCoeff());

    // A gain node of 0.5 behind the allocation.
    played.session.insertNodes (
        [] (NodeGraph& graph, GraphPlace place, int last)
        {
            if (place != GraphPlace::afterAllocation)
                return last;

            auto gains = std::make_unique<ChannelGainNode> (graph.node (last).outputs());
            gains->setGain (0.5);
            return graph.add (std::move (gains), last);
        });
    played.session.waitUntilSettled (std::array { spotPlayed });
    played.play (960);
    const auto halved = played.play (2400, { spotPlayed });
    CHECK ((halved - fused / 2).cwiseAbs().maxCoeff() < 1e-12 * fused.cwiseAbs().maxCoeff());
    played.session.setGraphOpen (false);
    played.session.waitUntilSettled (std::array { spotPlayed });
    played.play (960);
    CHECK (played.play (2400, { spotPlayed }) == fused);
}

TEST_CASE ("Sessions end in the middle of anything", "[session]")
{
    for (int i = 0; i < 20; ++i)
    {
        test::PlayedSession played;

        if (i % 4 != 0)
            played.session.prepare (rate);

        if (i % 3 == 0)
            played.session.fireAt (0.01, 0, 1);

        played.play (64 * i, { spotPlayed });
        played.change ([&] (PlaySettings& settings) { settings.xPercent = static_cast<float> (i); });
    }

    SUCCEED();
}
