#include "Support/TemporaryFolder.h"

#include <antinode_library/Library.h>
#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

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
