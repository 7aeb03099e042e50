#include "Support/ErrorText.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/OutlineReader.h>
#include <antinode_structure/DescribedModel.h>

#include <catch2/catch.hpp>

#include <numbers>

using namespace antinode;
using Json = nlohmann::json;

namespace
{
Json document (const std::string& outline, const std::string& edges, const std::string& more = "")
{
    return Json::parse (
        R"({ "schema": "antinode.device/1", "name": "pane", "kind": "plate", "outline": )" + outline + R"(, "edges": )"
        + edges + more
        + R"(, "thickness_mm": 1, "material": "glass", "quality_factor": 40, "limits": { "voltage_V": 100 },
                             "ceramics": [ { "shape": "disc", "centre_mm": [40, 30], "diameter_mm": 20, "thickness_mm": 0.3,
                                             "material": "NCE51", "mounting": "one_side", "wiring": "parallel" } ] })");
}

OutlinedPlate read (const Json& json)
{
    return std::get<OutlinedPlate> (readDevice (json, "my.json").body);
}

constexpr auto rounded = R"({ "shape": "rectangle", "size_x_mm": 150, "size_y_mm": 75, "radius_mm": 10,
                              "holes": [ { "shape": "circle", "diameter_mm": 14, "centre_mm": [128, 50] } ] })";

double areaIn (const std::string& outline)
{
    return 1e6 * areaOf (readOutline (JsonValue (Json::parse (outline), "outline")).outline);
}
} // namespace

TEST_CASE ("Shapes of outlines have the areas of their formulas", "[files][outlined]")
{
    using std::numbers::pi;
    CHECK (areaIn (rounded) == Approx (150 * 75 - (4 - pi) * 100 - pi * 49));
    CHECK (areaIn (R"({ "shape": "circle", "diameter_mm": 20 })") == Approx (pi * 100));
    CHECK (areaIn (R"({ "shape": "ring", "diameter_mm": 20, "inner_diameter_mm": 10 })") == Approx (pi * 75));
    CHECK (areaIn (R"({ "shape": "ellipse", "size_x_mm": 20, "size_y_mm": 10, "angle_deg": 30 })") == Approx (pi * 50));
    CHECK (areaIn (R"({ "shape": "polygon", "vertices_mm": [[0, 0], [30, 0], [30, 10], [10, 10], [10, 20], [0, 20]] })")
           == Approx (400));
    // A half disc: the arc goes through its top.
    CHECK (
        areaIn (
            R"({ "shape": "path", "start_mm": [10, 0], "pieces": [ { "to_mm": [-10, 0], "through_mm": [0, 10] } ] })")
        == Approx (pi * 50));
}

TEST_CASE ("An outline written as a path is read as the same outline", "[files][outlined]")
{
    for (const auto* const text :
         { rounded, R"({ "shape": "ellipse", "size_x_mm": 20, "size_y_mm": 10, "angle_deg": 30 })" })
    {
        const auto outline = readOutline (JsonValue (Json::parse (text), "outline")).outline;
        const auto json = outlineToJson (outline);
        const auto again = readOutline (JsonValue (json, "outline")).outline;
        CHECK (areaOf (again) == Approx (areaOf (outline)).epsilon (1e-12));
        CHECK (distanceToBoundary (again, outline.paths[0][1].start.x(), outline.paths[0][1].start.y()) < 1e-12);
    }
}

TEST_CASE ("Edges are held by their names, the rest as others, parts from place to place", "[files][outlined]")
{
    const auto plate = read (
        document (rounded, R"({ "left": "clamped", "hole_1": { "stiffness_N_per_mm2": 2, "rotation_stiffness_N": 3,
                                                     "loss_factor": 0.2 }, "others": "free",
                                                     "parts": [ { "from_mm": [50, 0], "to_mm": [100, 0], "support": "simply_supported" } ] })"));
    REQUIRE (plate.edges.size() == 6); // bottom, right, top, left, hole, part
    CHECK (plate.edges[3].condition == EdgeCondition::clamped);
    CHECK (plate.edges[4].translation == Approx (2e6));
    CHECK (plate.edges[4].rotation == 3);
    CHECK (plate.edges[4].lossFactor == 0.2);
    CHECK (plate.edges[5].condition == EdgeCondition::simplySupported);
    CHECK (lengthOfEdge (plate.outline, 5) == Approx (0.05));
    CHECK (lengthOfEdge (plate.outline, 0) == Approx (0.08 + std::numbers::pi / 2 * 0.01));
    CHECK (plate.common.ceramics[0].shape == CeramicShape::disc);
    CHECK (plate.common.ceramics[0].centre().x() == Approx (0.04));
    const auto all = read (document (rounded, R"("clamped")"));
    CHECK (std::all_of (all.edges.begin(), all.edges.end(),
                        [] (const auto& edge) { return edge.condition == EdgeCondition::clamped; }));
}

TEST_CASE ("Foundation, areas and points of a plate are read in SI units", "[files][outlined]")
{
    const auto plate =
        read (document (rounded, R"("free")", R"(, "foundation": { "stiffness_N_per_mm3": 0.01, "loss_factor": 0.1 },
        "areas": [ { "outline": { "shape": "circle", "diameter_mm": 10, "centre_mm": [20, 20] }, "mass_kg_m2": 1.5, "stiffness_N_per_mm3": 0.5 } ],
        "points": [ { "x_mm": 10, "y_mm": 20, "stiffness_N_per_mm": 4, "damping_N_s_per_m": 0.3, "mass_g": 2 } ])"));
    CHECK (plate.foundation == Approx (1e7));
    CHECK (plate.foundationLoss == 0.1);
    REQUIRE (plate.areas.size() == 1);
    CHECK (plate.areas[0].massPerArea == 1.5);
    CHECK (plate.areas[0].stiffness == Approx (5e8));
    REQUIRE (plate.points.size() == 1);
    CHECK (plate.points[0].stiffness == Approx (4e3));
    CHECK (plate.points[0].damping == 0.3);
    CHECK (plate.points[0].mass == Approx (2e-3));
}

TEST_CASE ("A rectangle keeps its solver unless something needs the other", "[files][outlined]")
{
    const auto make = [] (const std::string& left, const std::string& more)
    {
        auto json = Json::parse (
            R"({ "schema": "antinode.device/1", "name": "pane", "kind": "plate", "length_x_mm": 200, "length_y_mm": 120,
            "thickness_mm": 1, "material": "glass", "quality_factor": 40, "limits": { "voltage_V": 100 }, "ceramics": [],
            "edges": { "left": )"
            + left + R"(, "right": "free", "bottom": "free", "top": "free" })" + more + "}");
        return readDevice (json, "my.json").body;
    };
    CHECK (std::holds_alternative<PlateDescription> (make (R"("clamped")", "")));
    const auto elastic = std::get<OutlinedPlate> (make (R"({ "stiffness_N_per_mm2": 1 })", ""));
    CHECK (elastic.edges[3].translation == 1e6);
    CHECK (areaOf (elastic.outline) == Approx (0.024));
    const auto springs = elasticPieces ({ "pane", "", elastic });
    REQUIRE (springs.size() == 1);
    CHECK (springs[0].start.x() == 0);
    CHECK (springs[0].end.x() == 0);
    CHECK (std::holds_alternative<OutlinedPlate> (
        make (R"("clamped")", R"(, "points": [ { "x_mm": 10, "y_mm": 10, "mass_g": 1 } ])")));
}

TEST_CASE ("What is wrong with an outline is said with its place", "[files][outlined]")
{
    const auto error = [] (const Json& json) { return errorText ([&] { readDevice (json, "my.json"); }); };
    CHECK_THAT (error (document (R"({ "shape": "polygon", "vertices_mm": [[0, 0], [10, 10], [10, 0], [0, 10]] })",
                                 R"("free")")),
                Catch::StartsWith ("my.json: /outline: the outer path crosses or touches itself"));
    CHECK_THAT (error (document (R"({ "shape": "circle", "diameter_mm": 20,
                                      "holes": [ { "shape": "circle", "diameter_mm": 4, "centre_mm": [30, 0] } ] })",
                                 R"("free")")),
                Catch::StartsWith ("my.json: /outline: hole 1 lies outside the outer path"));
    CHECK_THAT (error (document (R"({ "shape": "circl", "diameter_mm": 20 })", R"("free")")),
                Catch::Contains ("my.json: /outline/shape") && Catch::Contains ("circle"));
    CHECK_THAT (error (document (rounded, R"({ "left": "free" })")), Catch::Contains ("bottom"));
    CHECK_THAT (
        error (document (
            rounded,
            R"({ "others": "free", "parts": [ { "from_mm": [50, 20], "to_mm": [60, 0], "support": "free" } ] })")),
        Catch::Contains ("/edges/parts/0/from_mm") && Catch::Contains ("from the outline"));
}

TEST_CASE ("A drawing that a device names becomes part of its document", "[files][outlined]")
{
    auto json = document (R"({ "file": "pane.svg", "layer": "glass" })", R"("free")");
    embedOutlineFiles (json, "/plates",
                       [] (const std::filesystem::path& file, const Json& choice)
                       {
                           CHECK (file == "/plates/pane.svg");
                           CHECK (choice.at ("layer") == "glass");
                           return readOutline (JsonValue (Json::parse (rounded), "outline")).outline;
                       });
    CHECK (json["outline"]["shape"] == "path");
    CHECK (areaOf (read (json).outline) * 1e6 == Approx (areaIn (rounded)));
}
