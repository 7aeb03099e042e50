#include "Support/ErrorText.h"
#include "Support/TemporaryFolder.h"

#include <Processor/AntinodeProcessor.h>
#include <Standalone/StandaloneSettings.h>
#include <antinode_base/System.h>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>
#include <iterator>

using namespace antinode;
namespace fs = std::filesystem;

namespace
{
StandaloneSettings unusualSettings()
{
    StandaloneSettings settings;
    settings.audio = { "JACK", "my \"system\" \xC3\xA4", 96000, 128, { 0, 3, 16 }, { 1 } };
    settings.routing = withMonitor (withOutput (straightRouting(), 1, 40), 100);
    settings.routing.chains[40] = { 1.0 / 3, -1 };
    settings.midi = { false, { "a", "b" } };
    settings.touch = { 9100, 0, "0.0.0.0", "firm" };
    settings.isDark = false;
    settings.scale = 1.5;
    settings.bench = { 3, -1, { 25, 4 } };
    settings.state = demonstrator();
    settings.state->parameters["x"] = 12.3456789012345678;
    return settings;
}

void write (const fs::path& file, const std::string& text)
{
    std::ofstream (file, std::ios::binary) << text;
}

std::string readContent (const fs::path& file)
{
    std::ifstream stream (file, std::ios::binary);
    return { std::istreambuf_iterator<char> (stream), {} };
}
} // namespace

TEST_CASE ("settings come back as they were kept")
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "deep" / "down" / "standalone.json";
    const auto wanted = unusualSettings();
    SettingsFile (path).save (wanted);
    SettingsFile file (path);
    const auto read = file.load();
    CHECK (file.warning().empty());
    CHECK (read.audio == wanted.audio);
    CHECK (read.routing == wanted.routing);
    CHECK (read.midi == wanted.midi);
    CHECK (read.bench == wanted.bench);
    CHECK (read.touch.oscPort == 9100);
    CHECK (read.touch.tuioPort == 0);
    CHECK (read.touch.address == "0.0.0.0");
    CHECK (read.touch.finger == "firm");
    CHECK_FALSE (read.isDark);
    CHECK (read.scale == 1.5);
    REQUIRE (read.state);
    CHECK (read.state->parameters == wanted.state->parameters);
    CHECK (settingsToText (read) == settingsToText (wanted));
    CHECK (std::distance (fs::directory_iterator (path.parent_path()), {}) == 1);
}

TEST_CASE ("settings of before there was a theme are dark")
{
    auto text = settingsToText (StandaloneSettings());
    const std::string theme = ",\n  \"theme\": \"dark\"";
    REQUIRE (text.find (theme) != std::string::npos);
    text.erase (text.find (theme), theme.size());
    CHECK (readSettings (text).isDark);
}

TEST_CASE ("settings of before there was an input open none")
{
    auto text = settingsToText (StandaloneSettings());
    const std::string inputs = ",\n    \"inputs\": []";
    REQUIRE (text.find (inputs) != std::string::npos);
    text.erase (text.find (inputs), inputs.size());
    CHECK (readSettings (text).audio.inputs.empty());
}

TEST_CASE ("where nothing is kept the usual settings apply")
{
    const TemporaryFolder folder;
    SettingsFile missing (folder.path() / "none.json"), none ({});
    CHECK (missing.load().routing == straightRouting());
    CHECK (missing.warning().empty());
    CHECK_FALSE (none.load().state);
    CHECK_NOTHROW (none.save (unusualSettings()));
}

TEST_CASE ("settings that cannot be read are put aside and never lost")
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "standalone.json";
    auto foreign = settingsToText (unusualSettings());
    foreign.replace (foreign.find ("standalone/1"), 12, "standalone/9");
    const auto good = settingsToText (unusualSettings());
    int number = 0;

    for (const auto& text : std::vector<std::string> { "", "{", good.substr (0, good.size() / 2), foreign, "[1, 2]",
                                                       std::string ("\0\xff\xfe", 3) })
    {
        write (path, text);
        SettingsFile file (path);
        CHECK (file.load().routing == straightRouting());
        CHECK (file.warning().find ("The settings could not be read") == 0);
        const auto aside = path.string() + ".broken" + (++number > 1 ? "-" + std::to_string (number) : "");
        CHECK (readContent (aside) == text);
        CHECK_FALSE (fs::exists (path));
    }
}

TEST_CASE ("settings that cannot be written are an error in a sentence")
{
    const TemporaryFolder folder;
    write (folder.path() / "file", "");
    SettingsFile file (folder.path() / "file" / "standalone.json");
    CHECK (errorText ([&] { file.save ({}); }).find ("the settings cannot be written") != std::string::npos);
}

TEST_CASE ("the next start removes what a dead process left, and nothing else")
{
    constexpr auto dead = "4194304"; // above what Linux gives
    const TemporaryFolder folder;
    const auto path = folder.path() / "standalone.json";
    SettingsFile (path).save (unusualSettings());
    const auto left = folder.path() / (".antinode-" + std::string (dead) + "-1");
    const auto own = path.string() + "." + std::to_string (ownProcess());
    fs::create_directory (left);
    write (left / "standalone.json", "{");
    write (path.string() + "." + dead, "{"); // of earlier versions
    write (own, "");
    write (path.string() + ".20261128", "");
    write (path.string() + ".old", "");
    CHECK (SettingsFile (path).load().audio == unusualSettings().audio);
    CHECK_FALSE (fs::exists (left));
    CHECK_FALSE (fs::exists (path.string() + "." + dead));
    CHECK (fs::exists (own));
    CHECK (fs::exists (path.string() + ".20261128"));
    CHECK (fs::exists (path.string() + ".old"));
}

TEST_CASE ("settings lie where XDG says")
{
    const auto* const before = std::getenv ("XDG_CONFIG_HOME");
    const std::string kept = before != nullptr ? before : "";
    setenv ("XDG_CONFIG_HOME", "/somewhere", 1);
    CHECK (usualSettingsFile() == "/somewhere/antinode/standalone.json");
    setenv ("XDG_CONFIG_HOME", "", 1);
    CHECK (usualSettingsFile() == fs::path (std::getenv ("HOME")) / ".config/antinode/standalone.json");
    setenv ("XDG_CONFIG_HOME", kept.c_str(), 1);
}
