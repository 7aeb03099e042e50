#include "Support/TemporaryFolder.h"

#include <antinode_base/System.h>

#include <catch2/catch.hpp>

#include <array>
#include <cerrno>
#include <fstream>
#include <string>

using namespace antinode;

TEST_CASE ("Bytes of a file come as they are, line ends too", "[system]")
{
    const TemporaryFolder folder;
    const auto path = folder.path() / u8"Gerät 1.txt";
    std::ofstream (path, std::ios::binary) << "a\r\nb\x1a"
                                           << "c\n";
    const auto file = openForReading (path);
    REQUIRE (file >= 0);
    const auto status = statusOf (file);
    REQUIRE (status.has_value());
    CHECK (status->isPlain);
    CHECK (status->bytes == 7);
    std::array<char, 16> bytes {};
    CHECK (readBytes (file, bytes.data(), bytes.size()) == 7);
    CHECK (std::string (bytes.data())
           == "a\r\nb\x1a"
              "c\n");
    CHECK (readBytes (file, bytes.data(), bytes.size()) == 0);
    closeFile (file);
}

TEST_CASE ("Text in UTF-8 is the name of a file, to a path and back", "[system]")
{
    const std::string name = "Gerät 日本 \U0001F3B5.json";
    const std::filesystem::path path (name);
    CHECK (path == std::filesystem::path (u8"Gerät 日本 \U0001F3B5.json"));
    CHECK (path.string() == name);
}

TEST_CASE ("A folder says that it is one, a missing file that it is missing", "[system]")
{
    const TemporaryFolder folder;
    const auto opened = openForReading (folder.path());
    REQUIRE (opened >= 0);
    CHECK (statusOf (opened)->isFolder);
    closeFile (opened);
    CHECK (openForReading (folder.path() / "missing") < 0);
    CHECK (errno == ENOENT);
}

TEST_CASE ("This process runs, a number that no process has does not", "[system]")
{
    constexpr auto beyondAll = 2'000'000'003;
    CHECK (ownProcess() > 0);
    CHECK (isProcessRunning (ownProcess()));
    CHECK_FALSE (isProcessRunning (beyondAll));
}
