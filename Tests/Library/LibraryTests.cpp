#include "Support/TemporaryFolder.h"

#include <antinode_base/InputError.h>
#include <antinode_documents/Inputs.h>
#include <antinode_text/OutputFolder.h>
#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>

using namespace antinode;

TEST_CASE ("The user's own devices are kept, found by name, replaced and removed", "[library]")
{
    const TemporaryFolder folder;
    setenv ("XDG_DATA_HOME", folder.path().c_str(), 1);
    auto json = loadDocument (LibraryKind::device, "beam");
    json["thickness_mm"] = 3;
    saveDocument (LibraryKind::device, "thick beam", json);
    CHECK (loadDocument (LibraryKind::device, "thick beam") == json);
    CHECK (libraryEntries (LibraryKind::device).back().name == "thick beam");
    CHECK_FALSE (libraryEntries (LibraryKind::device).back().isFactory);
    CHECK (libraryEntries (LibraryKind::focus).back().isFactory);
    json["thickness_mm"] = 4;
    saveDocument (LibraryKind::device, "thick beam", json);
    CHECK (loadDocument (LibraryKind::device, "thick beam")["thickness_mm"] == 4);
    removeDocument (LibraryKind::device, "thick beam");
    CHECK_THROWS_WITH (loadDocument (LibraryKind::device, "thick beam"), Catch::Contains ("; allowed: "));
    CHECK_THROWS_WITH (removeDocument (LibraryKind::device, "thick beam"), Catch::Contains ("is not a user preset"));
    unsetenv ("XDG_DATA_HOME");
}

TEST_CASE ("Invalid names of user presets are refused", "[library]")
{
    const TemporaryFolder folder;
    setenv ("XDG_DATA_HOME", folder.path().c_str(), 1);
    const auto json = loadDocument (LibraryKind::device, "beam");

    for (const auto* const name : { "", "beam", "../beam", ".hidden", "a/b", "quote\"" })
    {
        INFO (name);
        CHECK_THROWS_WITH (saveDocument (LibraryKind::device, name, json), Catch::StartsWith ("name '"));
    }

    unsetenv ("XDG_DATA_HOME");
}

TEST_CASE ("Every embedded focus and all embedded waveforms name an embedded device", "[library]")
{
    const auto devices = factoryNames (LibraryKind::device);

    for (const auto kind : { LibraryKind::focus, LibraryKind::waveforms })
        for (const auto& name : factoryNames (kind))
        {
            INFO (name);
            const auto device = namedDevice (kind, name, {});
            CHECK (std::find (devices.begin(), devices.end(), device) != devices.end());
        }

    CHECK (namedDevice (LibraryKind::focus, "phone-thumb", {}) == "phone");
}

TEST_CASE ("The device that a file names begins at its folder, a name stays one, an assignment replaces it",
           "[library]")
{
    const TemporaryFolder folder;
    const auto file = (folder.path() / "focus.json").string();
    auto focus = loadDocument (LibraryKind::focus, "demonstrator");
    const auto named = [&] (const nlohmann::json& device, const std::vector<std::string>& assignments = {})
    {
        focus["device"] = device;
        writeWholeFile (file, focus.dump());
        return namedDevice (LibraryKind::focus, file, assignments);
    };
    CHECK (named ("glass-148x210") == "glass-148x210");
    CHECK (named ("plates/mine.json") == folder.path() / "plates/mine.json");
    CHECK (named ("/else/mine.json") == "/else/mine.json");
    CHECK (named ("beam", { "focus.device=phone" }) == "phone");
    CHECK_THROWS_WITH (named (""), Catch::Contains ("focus.json: /device: is empty; allowed: "));
    CHECK_THROWS_WITH (named (3), Catch::Contains ("focus.json: /device: "));
    CHECK_THROWS_WITH (loadFocus (file, {}), Catch::Contains ("focus.json: /device: "));
    focus.erase ("device");
    writeWholeFile (file, focus.dump());
    CHECK (namedDevice (LibraryKind::focus, file, {}).empty());
}
