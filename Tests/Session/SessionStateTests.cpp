#include "PlayedSession.h"

#include <antinode_base/InputError.h>
#include <antinode_session/SessionState.h>

#include <catch2/catch.hpp>

#include <fstream>
#include <iterator>
#include <string>

using namespace antinode;

TEST_CASE ("A state read and written again is the same text", "[session]")
{
    const SessionState state { std::make_shared<const DeviceDocument> (test::deviceNamed ("phone")),
                               std::make_shared<const FocusDocument> (test::focusNamed ("phone-thumb")),
                               { { "x", 1.0 / 3 }, { "arm", 1 }, { "from_the_future", 7 } },
                               0x8000000000000005ULL };
    const auto text = stateToText (state);
    const auto again = readState (text);
    CHECK (stateToText (again) == text);
    CHECK (again.parameters.at ("x") == 1.0 / 3);
    CHECK (again.mutes == 0x8000000000000005ULL);
}

TEST_CASE ("An open graph is kept, and a state of the fused one says nothing of it", "[session]")
{
    SessionState state { std::make_shared<const DeviceDocument> (test::deviceNamed ("beam")),
                         std::make_shared<const FocusDocument> (test::focusNamed ("demonstrator")),
                         {},
                         0 };
    CHECK (stateToText (state).find ("open_graph") == std::string::npos);
    CHECK_FALSE (readState (stateToText (state)).isGraphOpen);
    state.isGraphOpen = true;
    CHECK (readState (stateToText (state)).isGraphOpen);
    auto json = nlohmann::json::parse (stateToText (state));
    json["open_graph"] = 1;
    CHECK_THROWS_WITH (readState (json.dump()), Catch::Contains ("/open_graph"));
}

TEST_CASE ("A state that is none says where and why", "[session]")
{
    CHECK_THROWS_WITH (readState ("[]"), Catch::StartsWith ("state"));
    CHECK_THROWS_WITH (readState (R"({"schema":"antinode.state/9"})"), Catch::Contains ("antinode.state/1"));
    const SessionState state { std::make_shared<const DeviceDocument> (test::deviceNamed ("beam")),
                               std::make_shared<const FocusDocument> (test::focusNamed ("demonstrator")),
                               { { "x", 1 } },
                               0 };
    auto json = nlohmann::json::parse (stateToText (state));
    json["parameters"]["x"] = "left";
    CHECK_THROWS_WITH (readState (json.dump()), Catch::Contains ("/parameters/x"));
    json["parameters"]["x"] = 1;
    json["muted_ceramics"] = { 65 };
    CHECK_THROWS_WITH (readState (json.dump()), Catch::Contains ("/muted_ceramics/0"));
}

TEST_CASE ("States of each role load as the versions before wrote them, and say the same when written again",
           "[session]")
{
    const auto [name, role] = GENERATE (table<std::string, const SessionRole*> (
        { { "foci", &SessionRole::foci }, { "fingers", &SessionRole::fingers }, { "plate", &SessionRole::plate } }));
    CAPTURE (name);
    std::ifstream file (ANTINODE_TEST_DATA "/States/" + name + ".json");
    const std::string text { std::istreambuf_iterator<char> (file), {} };
    const auto state = readState (text, *role);
    CHECK ((state.focus == nullptr) == (role == &SessionRole::plate));
    CHECK (state.following.isOn() == (role != &SessionRole::plate));
    CHECK (nlohmann::json::parse (stateToText (state, *role)) == nlohmann::json::parse (text));

    for (const auto* const other : { &SessionRole::foci, &SessionRole::fingers, &SessionRole::plate })
        if (other != role)
            CHECK_THROWS_WITH (readState (text, *other), Catch::Contains ("schema"));
}
