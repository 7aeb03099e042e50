#include "Support/SineBeam.h"
#include "Support/WaitForBank.h"

#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FocusPlaces.h>
#include <antinode_graph/VoiceNode.h>
#include <antinode_session/DesignWorker.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <thread>

using namespace antinode;

namespace
{
constexpr double rate = 48000;
constexpr int ceramics = 6;

DesignRequest requestFor (int places, double width = 0.03)
{
    DesignRequest request;
    request.model = std::make_shared<const ModalModel> (test::sineBeam (10, ceramics));
    request.focus.targets = { Target {} };
    request.focus.targets[0].width = width;
    request.focus.targets[0].peakVelocity = 0.02;
    request.focus.focusTime = 0.02;
    request.focus.modes.count = 5;
    request.places = bankPlaces (request.model->surface, places, 0.02);
    request.playback = { Reconstruction::bandLimited, rate };
    return request;
}

/** Samples of so high a rate that one design takes many seconds, and one step of its solver less than one. */
DesignRequest slowRequest (int places)
{
    auto slow = requestFor (places);
    slow.model = std::make_shared<const ModalModel> (test::sineBeam (24, ceramics));
    slow.focus.modes.count = 24;
    slow.focus.focusTime = 0.05;
    slow.focus.allocation.method = AllocationMethod::leastVoltage;
    slow.playback.sampleRate = 768000;
    return slow;
}

/** Plays one note from the start and returns the first ceramic's voltages. */
Eigen::VectorXd firstChannel (FocusPlayer& player, int place, int length)
{
    Eigen::MatrixXd voltages (length, ceramics);
    std::vector<double*> channels;

    for (int i = 0; i < ceramics; ++i)
        channels.push_back (voltages.col (i).data());

    const FocusEvent event { 0, FocusEventKind::trigger, place, 1 };
    player.process (channels.data(), length, std::span (&event, 1));
    return voltages.col (0);
}
} // namespace

TEST_CASE ("A worker designs a bank and hands it over", "[graph]")
{
    FocusPlayer player (ceramics, rate, {});
    DesignWorker worker (player.handOver());
    worker.request (requestFor (12));
    test::waitForBank (worker, 12);
    CHECK (worker.progress().designed == 13); // The focus at its own place among them.
    CHECK (worker.progress().failed == 0);
    CHECK (firstChannel (player, 3, 2000).cwiseAbs().maxCoeff() > 0);
    CHECK (firstChannel (player, 12, 2000).cwiseAbs().maxCoeff() == 0); // Beyond the bank.
    CHECK (player.counters().empty == 1);
}

TEST_CASE ("Rapid requests coalesce: the last one wins", "[graph]")
{
    FocusPlayer once (ceramics, rate, {}), often (ceramics, rate, {});
    DesignWorker first (once.handOver()), second (often.handOver());

    for (int i = 0; i < 50; ++i)
        second.request (requestFor (20, 0.02 + 0.0002 * i));

    first.request (requestFor (20, 0.02 + 0.0002 * 49));
    test::waitForBank (first, 20);
    test::waitForBank (second, 20);
    CHECK (second.progress().designed == 21);
    CHECK (firstChannel (once, 7, 2000) == firstChannel (often, 7, 2000));
}

TEST_CASE ("A design that takes long is given up for a newer request", "[graph]")
{
    BankHandOver handOver;
    DesignWorker worker (handOver);
    worker.request (slowRequest (1));
    std::this_thread::sleep_for (std::chrono::milliseconds (50));
    worker.request (requestFor (2));
    std::vector<std::int64_t> ends;

    while (! worker.progress().isDone() || ends.empty())
    {
        std::this_thread::sleep_for (std::chrono::milliseconds (1));

        if (const auto* const bank = handOver.take())
        {
            ends.push_back (bank->foci[FocusBank::livePlace]->endSample);
            handOver.giveBack (bank);
        }
    }

    CHECK (worker.progress().failed == 0);
    CHECK (worker.progress().designed == 3);
    CHECK (*std::max_element (ends.begin(), ends.end()) < static_cast<std::int64_t> (0.04 * rate));
}

TEST_CASE ("What is given up leaves the bank before playing, and the next request is designed", "[graph]")
{
    FocusPlayer player (ceramics, rate, {});
    DesignWorker worker (player.handOver());
    worker.request (requestFor (12));
    test::waitForBank (worker, 12);
    const auto before = firstChannel (player, 11, 2000);
    worker.request (slowRequest (12));
    std::this_thread::sleep_for (std::chrono::milliseconds (50));
    CHECK_FALSE (worker.progress().isDone());
    worker.abandon();
    CHECK (worker.progress().isDone());
    CHECK (firstChannel (player, 11, 2000) == before);
    worker.request (requestFor (12, 0.025));
    test::waitForBank (worker, 12);
    CHECK (worker.progress().designed == 13);
    CHECK (worker.progress().failed == 0);
    CHECK_FALSE (firstChannel (player, 11, 2000).isApprox (before, 1e-3));
}

TEST_CASE ("The focus at its own place is handed over first, then the place that is wanted, then the others", "[graph]")
{
    BankHandOver handOver;
    DesignWorker worker (handOver);
    auto request = requestFor (128);
    request.first = { 77 };
    worker.request (request);
    std::unique_ptr<const FocusBank> bank;

    while (bank == nullptr)
        bank.reset (handOver.take());

    CHECK (bank->foci[FocusBank::livePlace] != nullptr);
    CHECK (bank->foci[0] == nullptr); // The farthest by number: designed last.
    const auto wanted = 77;
    worker.waitFor (std::span (&wanted, 1));

    if (std::unique_ptr<const FocusBank> newer (handOver.take()); newer != nullptr)
        bank = std::move (newer);

    CHECK (bank->foci[77] != nullptr);
    test::waitForBank (worker, 128);
    CHECK (worker.progress().designed == 129);
    CHECK (worker.progress().firstMilliseconds > 0);
}

TEST_CASE ("A worker says when the wanted places are there", "[graph]")
{
    BankHandOver handOver;
    DesignWorker worker (handOver);
    auto request = requestFor (128);
    request.first = { 3, 100, 300 }; // The last one is beyond the bank.
    worker.request (request);
    DesignProgress progress;

    while (! progress.hasFirst)
        progress = worker.progress();

    const std::unique_ptr<const FocusBank> bank (handOver.take());
    CHECK (bank->foci[3] != nullptr);
    CHECK (bank->foci[100] != nullptr);
}

TEST_CASE ("A place that somebody waits for comes before all others", "[graph]")
{
    BankHandOver handOver;
    DesignWorker worker (handOver);
    worker.request (requestFor (128));
    const std::array wanted { 100, 90 };
    worker.waitFor (wanted);
    const std::unique_ptr<const FocusBank> bank (handOver.take());
    REQUIRE (bank != nullptr);
    CHECK (bank->foci[100] != nullptr);
    CHECK (bank->foci[90] != nullptr);
}

TEST_CASE ("A touched position is designed in addition to the bank and reported when it is ready", "[graph]")
{
    BankHandOver handOver;
    DesignWorker worker (handOver);
    worker.request (requestFor (5));
    std::atomic<int> place { -2 }, failed { -2 };
    REQUIRE (worker.touch (0.031, 0, [&] (int ready) { place = ready; }));
    REQUIRE (worker.touch (5, 0, [&] (int ready) { failed = ready; }));
    test::waitForBank (worker, 5);

    while (place == -2 || failed == -2)
        std::this_thread::yield();

    CHECK (place == FocusBank::firstTouchPlace);
    CHECK (failed == -1);
    CHECK (worker.progress().designed == 6);
    const std::unique_ptr<const FocusBank> bank (handOver.take());
    CHECK (bank->foci[FocusBank::firstTouchPlace] != nullptr);
    CHECK (bank->foci[FocusBank::firstTouchPlace + 1] == nullptr);
}

TEST_CASE ("A place that cannot be designed stays silent and says why", "[graph]")
{
    FocusPlayer player (ceramics, rate, {});
    DesignWorker worker (player.handOver());
    auto request = requestFor (3);
    request.places[1] = { 5.0, 0.0 };
    worker.request (request);
    test::waitForBank (worker, 3);
    CHECK (worker.progress().failed == 1);
    CHECK (worker.progress().failedNotes == std::vector { 1 });
    CHECK_THAT (worker.progress().error, Catch::Contains ("outside the surface"));
    CHECK (firstChannel (player, 1, 500).cwiseAbs().maxCoeff() == 0);
    CHECK (firstChannel (player, 2, 500).cwiseAbs().maxCoeff() > 0);
}

TEST_CASE ("A bank of free waveforms is designed and played, and each place has the samples of its own design",
           "[graph][sampled]")
{
    FocusPlayer player (ceramics, rate, {});
    DesignWorker worker (player.handOver());
    auto request = requestFor (5);
    request.focus.allocation.method = AllocationMethod::leastVoltage;
    request.focus.allocation.timesBound = upToLimits;
    worker.request (request);
    test::waitForBank (worker, 5);
    CHECK (worker.progress().failed == 0);
    const auto [x, y] = request.places[3];
    const auto design =
        designFocus (*request.model, movedTo (request.focus, x, y), request.playback, DesignExtent::playable);
    const auto& expected = design.program.samples->values;
    const auto played = firstChannel (player, 3, static_cast<int> (expected.cols()));
    CHECK ((played - expected.row (0).transpose()).cwiseAbs().maxCoeff() < 1e-6 * expected.cwiseAbs().maxCoeff());
}

TEST_CASE (
    "Places of a bank know the modes beyond the device's own, looked for once, and guard what the first one needed",
    "[graph][sampled]")
{
    const WideModel wide { test::sineBeam (20, ceramics), 10, {}, {} };
    std::atomic<int> asked { 0 };
    FocusPlayer player (ceramics, rate, {});
    DesignWorker worker (player.handOver());
    auto request = requestFor (5);
    request.focus.allocation.method = AllocationMethod::leastVoltage;
    request.widen = [&]
    {
        ++asked;
        return wide;
    };
    worker.request (request);
    test::waitForBank (worker, 5);
    worker.request (request);
    test::waitForBank (worker, 5);
    CHECK (asked == 1);
    CHECK (worker.progress().failed == 0);
    const auto first = designWithin (wide, request.focus, request.playback, DesignExtent::playable);
    REQUIRE (worker.progress().volts.size() == 5);
    const auto guarded = firstModes (wide.model, wide.known + first.spillOver->guardedBeyond);
    const auto [x, y] = request.places[3];
    const auto design = designGuarding (guarded, wide.known, movedTo (request.focus, x, y), request.playback);
    const auto& expected = design.program.samples->values;
    CHECK (worker.progress().volts[3].peak == peakVoltage (design));
    CHECK (worker.progress().volts[3].peak <= 1.25 * worker.progress().volts[3].bound * (1 + 1e-9));
    const auto played = firstChannel (player, 3, static_cast<int> (expected.cols()));
    CHECK ((played - expected.row (0).transpose()).cwiseAbs().maxCoeff() < 1e-6 * expected.cwiseAbs().maxCoeff());
}

TEST_CASE ("Where a bank of samples would not fit into its memory its places say so, and the focus itself plays",
           "[graph][sampled]")
{
    FocusPlayer player (ceramics, 768000, {});
    DesignWorker worker (player.handOver());
    auto request = requestFor (128);
    request.focus.allocation.method = AllocationMethod::leastVoltage;
    request.focus.allocation.timesBound = upToLimits;
    request.focus.focusTime = 0.12;
    request.playback.sampleRate = 768000;
    worker.request (request);
    test::waitForBank (worker, 128);
    CHECK (worker.progress().failed == 128);
    CHECK (worker.progress().liveError.empty());
    CHECK_THAT (worker.progress().error, Catch::Contains ("needs 306 MiB for the samples of 145 places; allowed: "
                                                          "256 MiB; choose a shorter focus time"));
    CHECK (firstChannel (player, FocusBank::livePlace, 1000).cwiseAbs().maxCoeff() > 0);
    firstChannel (player, 3, 1000);
    CHECK (player.counters().empty == 1);
}

TEST_CASE ("Where the places of touches would not fit beside the focus itself, a touch has none", "[graph][sampled]")
{
    BankHandOver handOver;
    DesignWorker worker (handOver);
    auto request = requestFor (0);
    request.model = std::make_shared<const ModalModel> (test::sineBeam (2, 64));
    request.focus.allocation.method = AllocationMethod::leastVoltage;
    request.focus.allocation.timesBound = upToLimits;
    request.focus.modes.count = 1;
    request.focus.focusTime = 0.35; // 64 ceramics of 4 bytes: 17 MB, 17 times
    request.playback.sampleRate = 192000;
    worker.request (request);
    test::waitForBank (worker, 0);
    REQUIRE (worker.progress().liveError.empty());
    std::atomic<int> place { -2 };
    REQUIRE (worker.touch (0.031, 0, [&] (int ready) { place = ready; }));

    while (place == -2)
        std::this_thread::yield();

    CHECK (place == -1);
}

TEST_CASE ("The places of a bank on a line and on a plate", "[graph]")
{
    Surface surface;
    surface.xMinimum = -0.1;
    surface.xMaximum = 0.1;
    const auto line = bankPlaces (surface, 5, 0.02);
    REQUIRE (line.size() == 5);
    CHECK (line[0].first == Approx (-0.08));
    CHECK (line[2].first == Approx (0).margin (1e-12));
    CHECK (line[4].first == Approx (0.08));
    CHECK (bankPlaces (surface, 0, 0.02).empty());

    surface.kind = SurfaceKind::plate;
    surface.yMaximum = 0.1;
    const auto grid = bankPlaces (surface, 128, 0.01);
    REQUIRE (grid.size() == 128);
    CHECK (grid[0].first == Approx (-0.09));
    CHECK (grid[0].second == Approx (0.01));
    CHECK (grid[15].first == Approx (0.09));
    CHECK (grid[15].second == Approx (0.01));
    CHECK (grid[127].first == Approx (0.09));
    CHECK (grid[127].second == Approx (0.09));
    CHECK (bankPlaces (surface, 0, 0.01).empty());
}
