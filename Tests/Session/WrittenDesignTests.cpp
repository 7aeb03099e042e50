#include "PlayedSession.h"

#include <antinode_base/InputError.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_session/Documents.h>
#include <antinode_session/SessionState.h>

#include <catch2/catch.hpp>

#include <memory>

using namespace antinode;

namespace
{
constexpr double designRate = 48000;
constexpr int designLength = 2400;

const ModalModel& staple()
{
    static const auto model = solveDevice (test::deviceNamed ("staple").description, {}, true);
    return model;
}

nlohmann::json writtenBy (AllocationMethod method, double sampleRate = designRate)
{
    auto focus = test::focusNamed ("demonstrator").description;
    focus.allocation.method = method;
    const auto design = designFocus (staple(), focus, { Reconstruction::bandLimited, sampleRate });
    return nlohmann::json::parse (designToJson (design, staple()).dump());
}

std::shared_ptr<const FocusDocument> documentOf (const nlohmann::json& json)
{
    return std::make_shared<const FocusDocument> (readFocusDocument (json, "design.json"));
}

/** What `antinode render --design` plays, in full scales. */
Eigen::MatrixXd rendered (const nlohmann::json& json)
{
    RenderSettings settings;
    settings.playback = { Reconstruction::bandLimited, designRate };
    settings.duration = designLength / designRate;
    settings.probeShapes.resize (0, staple().modes());
    const auto design = readDesign (json, "design.json", staple());
    return renderOffline (staple(), design.program, settings).voltages.leftCols (designLength)
           / staple().fullScaleVoltage;
}

std::array<FocusEvent, 1> noteOn (int note)
{
    return { FocusEvent { 0, FocusEventKind::trigger, note, 1 } };
}

Eigen::MatrixXd playNote (test::PlayedSession& played, int note)
{
    const auto events = noteOn (note);
    played.session.waitUntilSettled (events);
    return played.play (designLength, { events.begin(), events.end() }).topRows (8);
}
} // namespace

TEST_CASE ("Every note plays a written design as it is rendered: oscillations and samples", "[session][written]")
{
    const auto method = GENERATE (AllocationMethod::exact, AllocationMethod::leastVoltage);
    const auto json = writtenBy (method);
    test::PlayedSession played;
    // Its own parameters, as a plug-in sets them where it loads one.
    played.change ([method] (PlaySettings& settings) { settings.method = method; });
    played.session.load (nullptr, documentOf (json));
    played.prepare (designRate);
    CHECK (played.session.snapshot()->isAsWritten);
    CHECK (played.session.snapshot()->notePlaces.empty());
    const auto expected = rendered (json);

    for (const auto note : { Session::spotNote, 20 })
    {
        CHECK ((playNote (played, note) - expected).cwiseAbs().maxCoeff() < 1e-6 * expected.cwiseAbs().maxCoeff());
        played.play (9600);
    }
}

// A written design differs from a new one where somebody changed it: that is what plays until a parameter says
// otherwise.
TEST_CASE ("A parameter that moves designs the focus of a written design again, and back plays it",
           "[session][written]")
{
    auto json = writtenBy (AllocationMethod::exact);

    for (auto& row : json["allocation"])
        for (auto& value : row)
            value = 0.5 * value.get<double>();

    test::PlayedSession played;
    played.session.load (nullptr, documentOf (json));
    played.prepare (designRate);
    const auto expected = rendered (json);
    const auto isWritten = [&] (const Eigen::MatrixXd& voltages)
    { return (voltages - expected).cwiseAbs().maxCoeff() < 1e-6 * expected.cwiseAbs().maxCoeff(); };
    CHECK (isWritten (playNote (played, 60)));
    played.play (9600);
    played.change ([] (PlaySettings& settings) { settings.peakVelocityMillimetresPerSecond = 20; });
    const auto again = playNote (played, 60);
    CHECK_FALSE (played.session.snapshot()->isAsWritten);
    // A new design for half the velocity: half of what was written before it was halved.
    CHECK ((again - expected).cwiseAbs().maxCoeff() < 1e-3 * expected.cwiseAbs().maxCoeff());
    CHECK (played.session.snapshot()->notePlaces.size() == 128);
    played.play (9600);
    played.change ([] (PlaySettings& settings) { settings.peakVelocityMillimetresPerSecond = 40; });
    CHECK (isWritten (playNote (played, 60)));
}

TEST_CASE ("A written design that does not fit is one sentence, and silence", "[session][written]")
{
    test::PlayedSession played;
    std::string expected;
    auto json = writtenBy (AllocationMethod::leastVoltage, 96000);
    played.change ([] (PlaySettings& settings) { settings.method = AllocationMethod::leastVoltage; });

    SECTION ("samples of another rate")
    {
        expected = "designed for 96000 Hz";
    }
    SECTION ("other modes")
    {
        json["controlled_modes"][0]["frequency_Hz"] = 410;
        expected = "/controlled_modes/0: has 410 Hz";
    }
    SECTION ("a row too short")
    {
        json["samples"]["voltages_V"][3].erase (0);
        expected = "/samples/voltages_V/3";
    }

    played.session.load (nullptr, documentOf (json));
    played.session.prepare (designRate);
    CHECK (playNote (played, 60).isZero (0));
    CHECK_THAT (played.session.progress().liveError, Catch::Contains (expected));
    CHECK (played.session.progress().liveError.find ('\n') == std::string::npos);
}

TEST_CASE ("What cannot be played is said before it is loaded", "[session][written]")
{
    const auto fits = [] (const nlohmann::json& json, const char* device, double sampleRate)
    {
        requireFit (*documentOf (json), test::deviceNamed (device), &staple(),
                    { Reconstruction::bandLimited, sampleRate });
    };
    auto json = writtenBy (AllocationMethod::leastVoltage);
    CHECK_NOTHROW (fits (json, "staple", designRate));
    CHECK_NOTHROW (fits (json, "staple", 0));
    CHECK_THROWS_WITH (fits (json, "staple", 96000), Catch::Contains ("has samples of 48000 Hz"));
    CHECK_THROWS_WITH (fits (json, "beam", designRate),
                       Catch::Contains ("is for the device 'staple', and 'beam' is loaded"));
    json["samples"]["voltages_V"][7][2] = "much";
    CHECK_THROWS_WITH (fits (json, "staple", designRate), Catch::Contains ("/samples/voltages_V/7/2"));
    CHECK_NOTHROW (fits (writtenBy (AllocationMethod::exact), "staple", 96000));
}

TEST_CASE ("A state keeps a written design to the bit, with other fingers too", "[session][written]")
{
    const auto document = documentOf (writtenBy (AllocationMethod::leastVoltage));
    auto finger = builtInFinger ("light", 0.01, 0);
    finger.isKnown = false;
    const auto touched = std::make_shared<const FocusDocument> (withFingers (*document, { finger }));
    const SessionState state { std::make_shared<const DeviceDocument> (test::deviceNamed ("staple")), touched, {}, 0 };
    const auto text = stateToText (state);
    CHECK (nlohmann::ordered_json::parse (text).dump() == text);
    const auto again = readState (text);
    CHECK (stateToText (again) == text);
    CHECK (sayTheSame (*again.focus, *touched));
    CHECK_FALSE (sayTheSame (*again.focus, *document));
    CHECK (again.focus->description.fingers == std::vector { finger });
    REQUIRE (again.focus->design != nullptr);
    const auto& read = *again.focus->design;
    CHECK (designAsWritten (read, staple()).program.samples->values
           == designAsWritten (*document->design, staple()).program.samples->values);
    CHECK (writtenFor (*again.focus, again.focus->description) != nullptr);
    auto broken = nlohmann::json::parse (text);
    broken["design"]["focus_time_s"] = 1;
    broken["design"].erase ("playback");
    CHECK_THROWS_WITH (readState (broken.dump()), Catch::Contains ("state: design") && Catch::Contains ("playback"));
}
