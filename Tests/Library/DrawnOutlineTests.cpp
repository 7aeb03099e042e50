#include "Support/ErrorText.h"
#include "Support/TemporaryFolder.h"

#include <antinode_documents/Library.h>
#include <antinode_documents/OutlineReader.h>
#include <antinode_outline/Drawing.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <fstream>

using namespace antinode;

namespace
{
void write (const std::filesystem::path& file, const std::string& text)
{
    std::ofstream (file, std::ios::binary) << text;
}
} // namespace

TEST_CASE ("A device file that names a drawing beside it is loaded with the paths of the drawing", "[library][drawing]")
{
    const TemporaryFolder folder;
    write (folder.path() / "plate.svg", R"(<svg width="80" height="60" viewBox="0 0 80 60"><g id="rim">
        <rect width="80" height="60"/><circle cx="40" cy="20" r="10"/></g><text>80 x 60</text></svg>)");
    const auto device = (folder.path() / "plate.json").string();
    write (device, R"({ "kind": "plate", "outline": { "file": "plate.svg", "layer": "rim", "unit": "mm" } })");
    const auto outline = loadDocument (LibraryKind::device, device).at ("outline");
    CHECK (outline.at ("shape") == "path");
    CHECK (outline.at ("pieces").size() == 4);
    CHECK (outline.at ("start_mm") == nlohmann::json ({ 0, 60 })); // y points upwards.
    CHECK (outline.at ("holes").size() == 1);
}

TEST_CASE ("Drawings keep their outline through the document of a device", "[library][drawing]")
{
    for (const std::string file : { "inkscape.svg", "inkscape.dxf", "ezdxf-R2000.dxf" })
    {
        const auto path = std::string (ANTINODE_TEST_DATA) + "/Drawings/" + file;
        const nlohmann::json keys { { "file", file }, { "unit", "mm" }, { "layer", file[0] == 'e' ? "Outline" : "" } };
        const auto drawn = readDrawnOutline (path, keys);
        const auto document = nlohmann::json::parse (outlineToJson (drawn).dump());
        const auto read = readOutline (JsonValue (document, "plate.json")).outline;
        CHECK (read.paths.size() == drawn.paths.size());
        CHECK (areaOf (read) == Approx (areaOf (drawn)).epsilon (1e-9));
        CHECK (lengthOfEdge (read, 0) == Approx (lengthOfEdge (drawn, 0)).epsilon (1e-9));
    }
}

TEST_CASE ("A drawing that cannot be read is named, and why", "[library][drawing]")
{
    const TemporaryFolder folder;
    const auto device = (folder.path() / "plate.json").string();
    const auto error = [&] (const std::string& outline)
    {
        write (device, R"({ "kind": "plate", "outline": )" + outline + "}");
        return errorText ([&] { loadDocument (LibraryKind::device, device); });
    };
    write (folder.path() / "plate.svg",
           R"(<svg width="80" height="60" viewBox="0 0 80 60"><rect width="9" height="9"/></svg>)");
    CHECK_THAT (error (R"({ "file": "none.svg" })"), Catch::Contains ("none.svg: does not exist"));
    CHECK_THAT (error (R"({ "file": "plate.svg" })"), Catch::Contains ("plate.svg: width is '80'"));
    CHECK_THAT (error (R"({ "file": "plate.svg", "unit": "inch" })"),
                Catch::Contains ("/unit") && Catch::Contains ("'in'"));
    CHECK_THAT (error (R"({ "file": "plate.svg", "unit": "mm", "layer": "x" })"),
                Catch::Contains ("shows nothing in 'x'"));
}
