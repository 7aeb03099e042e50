#include "PlayedSession.h"

#include <antinode_focus/FocusPlaces.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <map>
#include <random>
#include <thread>

using namespace antinode;

namespace
{
constexpr double preparedRate = 48000;

/** Places along the staple, designed. */
struct PreparedSession : test::PlayedSession
{
    explicit PreparedSession (int places)
    {
        prepare (preparedRate);
        PlayControls disarmed;
        disarmed.isArmed = false;
        play (64, {}, disarmed);

        for (int slot = 0; slot < places; ++slot)
            session.prepareFocus (slot,
                                  preparesFocus (movedTo (session.snapshot()->focus, -0.06 + 0.12 * slot / places, 0)),
                                  [this, slot] (const PreparedFocus& focus)
                                  {
                                      const std::lock_guard lock (mutex);
                                      made[slot] = focus;
                                  });

        for (int i = 0; i < 12000 && ! isReady (places); ++i)
            std::this_thread::sleep_for (std::chrono::milliseconds (5));
    }

    bool isReady (int places)
    {
        const std::lock_guard lock (mutex);
        return static_cast<int> (made.size()) == places;
    }

    std::vector<PlayReport> reports()
    {
        std::vector<PlayReport> taken;

        while (const auto report = session.reports().take())
            taken.push_back (*report);

        return taken;
    }

    std::map<int, PreparedFocus> made;
};

/** The first sample with a voltage, or -1. */
Eigen::Index firstSound (const Eigen::MatrixXd& played)
{
    for (Eigen::Index n = 0; n < played.cols(); ++n)
        if (played.topRows (8).col (n).cwiseAbs().maxCoeff() > 1e-9)
            return n;

    return -1;
}
} // namespace

TEST_CASE ("Prepared places begin on the sample that is told, in whatever order they are played", "[session][prepared]")
{
    constexpr int places = 40, plays = 200, length = 4096;
    PreparedSession played (places);
    REQUIRE (played.isReady (places));
    std::mt19937 random (1);
    played.play (4096);
    played.reports();
    // The clock of a session counts all that it has played.
    REQUIRE (played.session.playPrepared (0, 1, 9999));
    const auto first = played.play (length);
    const auto told = played.reports();
    REQUIRE (told.size() == 2);
    CHECK (told[0].kind == PlayReport::Kind::begun);
    CHECK (told[0].request == 9999);
    CHECK (told[1].kind == PlayReport::Kind::finished);
    CHECK (told[1].peakVolts == Approx (played.made[0].peakVoltage).epsilon (0.01));
    CHECK (told[1].limitedSamples == 0);
    auto clock = told[0].onset - firstSound (first); // Of the block's first sample, to within a sample.

    for (int k = 0; k < plays; ++k)
    {
        clock += length;
        auto slot = static_cast<int> (random() % places);

        // On the middle line the target needs a mode above what 48 kHz can play.
        if (! played.made[slot].error.empty())
            slot = 0;

        const auto isLater = k % 2 == 1;
        const auto due = clock + static_cast<std::int64_t> (random() % 300);
        REQUIRE (played.session.playPrepared (slot, 0.5, static_cast<std::uint32_t> (k + 1), isLater ? due : 0));
        const auto sound = played.play (length);
        const auto reports = played.reports();
        REQUIRE (reports.size() == 2);
        CAPTURE (k, slot, reports[0].onset - clock, firstSound (sound));
        CHECK (std::abs (reports[0].onset - clock - firstSound (sound)) <= 1);
        CHECK (reports[0].focus - reports[0].onset
               == Approx (played.made[slot].focusSeconds * preparedRate).margin (20));

        if (isLater)
            CHECK (reports[0].onset - due == Approx (0).margin (20)); // Cycles are whole.
    }
}

TEST_CASE ("A stop ends what plays and what waits, and tells both", "[session][prepared]")
{
    PreparedSession played (2);
    played.play (1024);
    played.reports();
    REQUIRE (played.session.playPrepared (0, 1, 1));
    REQUIRE (played.session.playPrepared (1, 1, 2, 1 << 20));
    played.play (128);
    played.session.stopAll();
    const auto after = played.play (4800);
    CHECK (after.topRows (8).rightCols (4000).cwiseAbs().maxCoeff() < 1e-12);
    std::map<std::uint32_t, PlayReport::Kind> last;

    for (const auto& report : played.reports())
        last[report.request] = report.kind;

    CHECK (last.at (1) == PlayReport::Kind::stopped);
    CHECK (last.at (2) == PlayReport::Kind::stopped);
}

TEST_CASE ("Who disarms voids what is due later, and notes' stop what is due behind it", "[session][prepared]")
{
    PreparedSession played (1);
    PlayControls armed, disarmed;
    disarmed.isArmed = false;
    played.play (64, {}, armed);
    played.reports();
    REQUIRE (played.session.playPrepared (0, 1, 1, 1 << 20));
    played.play (64, {}, armed);
    played.play (64, {}, disarmed);
    auto told = played.reports();
    REQUIRE (told.size() == 1);
    CHECK (told[0].kind == PlayReport::Kind::stopped);
}

TEST_CASE ("A stop of notes voids what is due behind it in its block", "[session][prepared]")
{
    PreparedSession played (1); // Has played a block of 64 samples.
    played.play (64);
    played.reports();
    REQUIRE (played.session.playPrepared (0, 1, 2, 128 + 40));
    const auto sound = played.play (4096, { { 10, FocusEventKind::stopAll, 0, 0 } });
    CHECK (firstSound (sound) < 0);
    const auto told = played.reports();
    REQUIRE (told.size() == 1);
    CHECK (told[0].request == 2);
    CHECK (told[0].kind == PlayReport::Kind::stopped);
}

TEST_CASE ("A place without a design plays nothing and says so", "[session][prepared]")
{
    PreparedSession played (1);
    played.play (64);
    played.reports();
    REQUIRE (played.session.playPrepared (17, 1, 5));
    const auto sound = played.play (2400);
    CHECK (firstSound (sound) < 0);
    const auto reports = played.reports();
    REQUIRE (reports.size() == 1);
    CHECK (reports[0].kind == PlayReport::Kind::empty);
    CHECK (reports[0].request == 5);
}

TEST_CASE ("A place outside the surface is refused by the sentence of a file", "[session][prepared]")
{
    PreparedSession played (1);
    auto error = std::string();
    std::atomic<bool> isDone { false };
    played.session.prepareFocus (3, preparesFocus (movedTo (played.session.snapshot()->focus, 1, 0)),
                                 [&] (const PreparedFocus& focus)
                                 {
                                     error = focus.error;
                                     isDone = true;
                                 });

    for (int i = 0; i < 12000 && ! isDone; ++i)
        std::this_thread::sleep_for (std::chrono::milliseconds (5));

    CHECK (error == "focus: target 1 x: is 1000 mm, which is outside the surface; allowed: -75 to 75 mm");
}

TEST_CASE ("Prepared places are designed again for another device", "[session][prepared]")
{
    PreparedSession played (1);
    const auto volts = played.made.at (0).peakVoltage;
    {
        const std::lock_guard lock (played.mutex);
        played.made.clear();
    }
    auto thicker = test::deviceNamed ("staple");
    auto json = nlohmann::json::parse (thicker.text);
    json["thickness_mm"] = 3;
    played.session.load (std::make_shared<const DeviceDocument> (readDeviceDocument (json, "thicker")), nullptr);

    for (int i = 0; i < 12000 && ! played.isReady (1); ++i)
    {
        played.play (64);
        std::this_thread::sleep_for (std::chrono::milliseconds (1));
    }

    REQUIRE (played.isReady (1));
    CHECK (played.made.at (0).error.empty());
    CHECK (played.made.at (0).peakVoltage != volts);
}

TEST_CASE ("The clock of a session finds the line behind jittering blocks", "[session][prepared]")
{
    SampleClock clock;
    CHECK_FALSE (clock.timeOf (0));
    std::mt19937 random (2);
    std::exponential_distribution<double> late (1 / 0.0005); // s
    constexpr int block = 256;
    const auto timeAt = [] (double seconds)
    {
        return SampleClock::Time (
            std::chrono::duration_cast<SampleClock::Time::duration> (std::chrono::duration<double> (seconds)));
    };

    for (int k = 0; k < 20000; ++k)
        clock.begin (std::int64_t (k) * block, block, preparedRate,
                     timeAt (100 + k * block / preparedRate * 1.00002 + late (random)));

    // Its mean lateness stays: 0.5 ms.
    const auto told =
        std::chrono::duration<double> (clock.timeOf (std::int64_t (20000) * block)->time_since_epoch()).count();
    CHECK (told - (100 + 20000.0 * block / preparedRate * 1.00002) == Approx (0.0005).margin (0.0003));
    CHECK (std::abs (*clock.sampleAt (*clock.timeOf (1234567)) - 1234567) <= 1);
}

TEST_CASE ("A marker lasts from each focus on, whatever the blocks are", "[session][prepared]")
{
    PlayReports reports;
    const std::array voices { BegunVoice { 0, true, 10, 100, 200 }, BegunVoice { 0, true, 10, 130, 200 } };
    reports.begin (voices, 0, 0, {});
    std::vector<float> marker (512, -1);

    for (int begin = 0; begin < 512; begin += 64)
        reports.writeMarker (marker.data() + begin, 64, begin, 50);

    for (int n = 0; n < 512; ++n)
        REQUIRE (marker[static_cast<std::size_t> (n)] == (n >= 100 && n < 180 ? 1.0F : 0.0F));
}

TEST_CASE ("A voice that a newer one takes is told as stopped, one that has ended as finished", "[session][prepared]")
{
    PlayReports reports;
    const LevelMeters meters;

    for (std::uint32_t i = 1; i <= FocusVoices::soundingVoices + 2; ++i)
    {
        const std::array voice { BegunVoice { i, true, i, i + 100, i == 3 ? 20 : 1000 } };
        reports.begin (voice, 0, 0, meters);
    }

    std::vector<std::uint32_t> stopped, finished;

    while (const auto report = reports.take())
        if (report->kind != PlayReport::Kind::begun)
            (report->kind == PlayReport::Kind::stopped ? stopped : finished).push_back (report->request);

    CHECK (finished == std::vector<std::uint32_t> { 3 });
    CHECK (stopped == std::vector<std::uint32_t> { 1 });
}
