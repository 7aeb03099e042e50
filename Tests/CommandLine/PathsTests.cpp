#include "Support/RunProgram.h"

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

using namespace antinode;
using test::readContent;
using test::runProgram;

// Names of files and ends of lines as they are on computers of users: the results must not depend on them.

namespace
{
void writeFile (const std::filesystem::path& path, const std::string& content)
{
    std::filesystem::create_directories (path.parent_path());
    std::ofstream (path, std::ios::binary) << content;
}

/** The text as editors of Windows write it. */
std::string withWindowsLineEnds (const std::string& text)
{
    std::string other;

    for (const auto character : text)
        if (character == '\n')
            other += "\r\n";
        else if (character != '\r')
            other += character;

    return other;
}

std::string shown (const char* name)
{
    const auto run = runProgram ({ "devices", "--show", name });
    REQUIRE (run.exitCode == 0);
    return run.output;
}

/** design.json without the time that the design took. */
nlohmann::json designIn (const std::filesystem::path& folder)
{
    auto design = nlohmann::json::parse (readContent (folder / "design.json"));
    design.at ("certificate").erase ("time_ms");
    return design;
}
} // namespace

TEST_CASE ("Files and folders may have umlauts, spaces and other scripts in their names", "[command line][paths]")
{
    const TemporaryFolder folder;
    const auto strange = folder.path() / u8"Geräte für Übung 1 – 表面";
    const auto device = strange / u8"ein Gerät.json", focus = strange / u8"schöner Fokus.json";
    writeFile (device, shown ("staple"));
    writeFile (focus, shown ("demonstrator"));
    const auto plain = runProgram ({ "render", "--no-report", "--out", folder.path() / "plain" });
    const auto other =
        runProgram ({ "render", focus, "--device", device, "--no-report", "--out", strange / u8"Ergebnis ß" });
    INFO (other.errors);
    REQUIRE (plain.exitCode == 0);
    REQUIRE (other.exitCode == 0);
    CHECK (readContent (folder.path() / "plain" / "voltages.wav")
           == readContent (strange / u8"Ergebnis ß" / "voltages.wav"));
}

TEST_CASE ("A message names a file as the user wrote it, in UTF-8", "[command line][paths]")
{
    const auto run = runProgram ({ "modes", reinterpret_cast<const char*> (u8"kein Gerät ä 表.json") });
    CHECK (run.exitCode == 1);
    CHECK_THAT (run.errors, Catch::Contains (reinterpret_cast<const char*> (u8"kein Gerät ä 表.json")));
    CHECK_THAT (runProgram ({ "devices" }).output, ! Catch::Contains ("\r"));
}

TEST_CASE ("Devices and focuses may have the line ends of Windows", "[command line][paths]")
{
    const TemporaryFolder folder;

    for (const auto isWindows : { false, true })
    {
        const auto path = folder.path() / (isWindows ? "windows" : "unix");
        const auto text = [&] (const char* name)
        { return isWindows ? withWindowsLineEnds (shown (name)) : shown (name); };
        writeFile (path / "device.json", text ("staple"));
        writeFile (path / "focus.json", text ("demonstrator"));
        const auto run =
            runProgram ({ "design", path / "focus.json", "--device", path / "device.json", "--out", path });
        INFO (run.errors);
        REQUIRE (run.exitCode == 0);
    }

    CHECK_THAT (readContent (folder.path() / "windows" / "device.json"), Catch::Contains ("\r\n"));
    CHECK (designIn (folder.path() / "windows").dump() == designIn (folder.path() / "unix").dump());
}

TEST_CASE ("Tables may have the line ends of Windows", "[command line][paths]")
{
    const TemporaryFolder folder;
    writeFile (folder.path() / "points.csv", "x_mm,y_mm\n-20,0\n24,0\n");
    writeFile (folder.path() / "points-windows.csv", withWindowsLineEnds ("x_mm,y_mm\n-20,0\n24,0\n"));

    for (const auto* name : { "points", "points-windows" })
    {
        const auto run =
            runProgram ({ "measure", "--simulate", "--device", "beam", "--points",
                          folder.path() / (std::string (name) + ".csv"), "--rate", "24000", "--highest-hz", "8000",
                          "--resolution-hz", "4", "--periods", "2", "--settling", "2", "--out", folder.path() / name });
        INFO (run.errors);
        REQUIRE (run.exitCode == 0);
    }

    const auto size = std::filesystem::file_size (folder.path() / "points" / "responses.uff");
    CHECK (size > 1000);
    CHECK (std::filesystem::file_size (folder.path() / "points-windows" / "responses.uff") == size);
}

TEST_CASE ("The user's devices are found in the folder that the system has for them", "[command line][paths]")
{
    const TemporaryFolder folder;
    auto device = nlohmann::json::parse (shown ("beam"));
    device["name"] = "eigener Balken";
    writeFile (folder.path() / u8"Benutzer Müller" / "antinode" / "Devices" / "own-beam.json", device.dump (2));
    const test::ProgramEnvironment environment { { test::userDataVariable, folder.path() / u8"Benutzer Müller" } };
    CHECK (runProgram ({ "modes", "own-beam" }, environment).exitCode == 0);
    CHECK (runProgram ({ "modes", "own-beam" }).exitCode == 1);
}

TEST_CASE ("Names that are too long for the system are a sentence, in whatever writes", "[command line][paths]")
{
    const TemporaryFolder folder;
    const std::string longest (300, 'a');

    for (const auto& arguments :
         std::vector<test::ProgramArguments> { { "design", "--out", folder.path() / longest },
                                               { "render", "--no-report", "--out", folder.path() / "folder" / longest },
                                               { "place", "staple", "--count", "2", "--out", folder.path() / longest },
                                               { "map", "--places", "5", "--out", folder.path() / longest },
                                               { "excite", "--device", "staple", "--out", folder.path() / longest },
                                               { "modes", "staple", "--csv", folder.path() / longest },
                                               { "modes", longest } })
    {
        const auto run = runProgram (arguments);
        INFO (run.errors);
        CHECK (run.exitCode == 1);
        CHECK (test::linesIn (run.errors) == 1);
        CHECK (run.errors.find ("filesystem error") == std::string::npos);
        CHECK (run.errors.find ("terminate") == std::string::npos);
    }
}

TEST_CASE ("On a line every place with a y is refused, by whatever option or key it comes", "[command line]")
{
    const TemporaryFolder folder;
    const auto points = folder.path() / "points.csv";
    writeFile (points, "x_mm,y_mm\n10,0\n20,5\n");
    const auto out = folder.path() / "out";

    for (const auto& arguments : std::vector<test::ProgramArguments> {
             { "render", "--probe", "12,5", "--no-report", "--out", out },
             { "render", "--finger", "12,5", "--no-report", "--out", out },
             { "design", "--finger", "12,-5,firm", "--out", out },
             { "design", "--set", "focus.targets.0.y_mm=5", "--out", out },
             { "design", "--device", "beam", "--set", "focus.probes_mm=[[10,5]]", "--out", out },
             { "render", "--set", "focus.probes_mm=[[10,5]]", "--no-report", "--out", out },
             { "design", "--set", "focus.fingers=[{\"x_mm\":10,\"y_mm\":5,\"kind\":\"medium\"}]", "--out", out } })
    {
        const auto run = runProgram (arguments);
        INFO (run.errors);
        CHECK (run.exitCode == 1);
        CHECK (test::linesIn (run.errors) == 1);
        CHECK (run.errors.find ("is a line; allowed: 0") != std::string::npos);
        CHECK_FALSE (std::filesystem::exists (out));
    }
}
