#include "PlayedProcessor.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <iterator>

using namespace antinode;

namespace
{
std::string readFixture (const std::string& name)
{
    std::ifstream file (std::string (ANTINODE_TEST_DATA) + "/States/" + name, std::ios::binary);
    REQUIRE (file);
    return { std::istreambuf_iterator<char> (file), {} };
}
} // namespace

// What version 0.1.0 kept: every later version has to load it.
TEST_CASE ("States of earlier versions load", "[plugin]")
{
    const auto text = readFixture ("state-1.json");
    const auto processor = test::offlineProcessor (8, 48000, 512);
    processor->setStateInformation (text.data(), static_cast<int> (text.size()));
    CHECK (processor->warning().isEmpty());
    CHECK (processor->device()->description.name == "beam");
    CHECK (processor->focus()->description.name == "aluminium-centre");
    CHECK (processor->parameters().settings().xPercent == 37.5F);
    CHECK (processor->parameters().settings().widthMillimetres == Approx (18.25));
    CHECK (processor->parameters().controls().notes.noteOff == NoteOffBehaviour::brake);
    CHECK_FALSE (processor->parameters().arm().get());
    CHECK (processor->mutes() == 0b10010);
}
