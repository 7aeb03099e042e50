#include "Support/BrokenFiles.h"
#include "Support/ErrorText.h"
#include "Support/TemporaryFolder.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_text/JsonText.h>

#include <catch2/catch.hpp>

#include <fstream>

#include <unistd.h>

using namespace antinode;

namespace
{
void readFile (std::string_view bytes, bool isFocus)
{
    const auto document = parseJson (bytes, "my.json");

    if (isFocus)
        readFocus (document, "my.json");
    else
        readDevice (document, "my.json");
}

bool isOneSentence (const std::string& message)
{
    const auto isControl = [] (char c) { return static_cast<unsigned char> (c) < 0x20 || c == 0x7f; };
    return message.rfind ("my.json: ", 0) == 0 && message.size() > 12 && message.size() < 1500
           && std::none_of (message.begin(), message.end(), isControl);
}
} // namespace

TEST_CASE ("The files from which the broken ones are made are good", "[files]")
{
    for (const auto& good : goodFiles())
    {
        INFO (good.name);
        CHECK_NOTHROW (readFile (good.text, good.isFocus));
    }
}

TEST_CASE ("Every broken file gives one sentence that names the file", "[files]")
{
    const auto files = brokenFiles();
    REQUIRE (files.size() >= 300);

    for (const auto& file : files)
    {
        INFO (file.name);
        const auto message = errorText ([&] { readFile (file.bytes, file.isFocus); });
        INFO (message);
        CHECK (isOneSentence (message));
    }
}

TEST_CASE ("Paths that are not readable files are refused with a reason", "[files]")
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "my.json";

    CHECK (errorText ([&] { readJsonFile (path); }) == path.string() + ": does not exist");
    CHECK (errorText ([&] { readJsonFile (folder.path()); })
           == folder.path().string() + ": is a directory; allowed: a JSON file");
    CHECK (errorText ([&] { readJsonFile (""); }).find ("does not exist") != std::string::npos);

    std::ofstream (path).close();
    CHECK (errorText ([&] { readJsonFile (path); }) == path.string() + ": is empty; allowed: a JSON document");
    CHECK (errorText ([&] { readJsonFile (path / "below.json"); })
           == (path / "below.json").string() + ": does not exist");
}

TEST_CASE ("A file that opens but cannot be read is an error", "[files]")
{
    // Address 0 of a process is never mapped: the first read fails, for root as well.
    CHECK (errorText ([] { readJsonFile ("/proc/self/mem"); }).find ("/proc/self/mem: cannot be read: ") == 0);

    const TemporaryFolder folder;
    const auto path = folder.path() / "secret.json";
    std::ofstream (path) << "{}";
    std::filesystem::permissions (path, std::filesystem::perms::none);

    if (geteuid() != 0)
        CHECK (errorText ([&] { readJsonFile (path); }) == path.string() + ": cannot be read: Permission denied");
}

TEST_CASE ("A file without end is not read without end", "[files]")
{
    CHECK (errorText ([] { readJsonFile ("/dev/zero"); }) == "/dev/zero: is too large; allowed: up to 64 MiB");
}
