#include "Support/ErrorText.h"

#include <antinode_base/InputError.h>
#include <antinode_documents/DeviceFile.h>
#include <antinode_model/Surface.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace antinode;
using Json = nlohmann::json;

namespace
{
/** A ring, held along its hole, with a disc and a mass: what has points off the plate, in cut cells, and without area.
 */
ModalModel ring()
{
    const auto json = Json::parse (
        R"({ "schema": "antinode.device/1", "name": "ring", "kind": "plate", "outline": { "shape": "ring", "diameter_mm": 120,
             "inner_diameter_mm": 40 }, "edges": { "inner": "clamped", "outer": "free" }, "thickness_mm": 1, "material": "glass",
             "quality_factor": 40, "limits": { "voltage_V": 100 }, "modes": { "count": 10 },
             "points": [ { "x_mm": -40, "y_mm": 3, "mass_g": 1 } ],
             "ceramics": [ { "shape": "disc", "centre_mm": [40, 0], "diameter_mm": 16, "thickness_mm": 0.3, "material": "NCE51" } ] })");
    return solveStructure (readDevice (json, "ring.json"));
}

ModalModel writtenAndRead (const ModalModel& model)
{
    const auto text = modalDeviceToJson (model, "").dump();
    return std::get<ModalModel> (readDevice (Json::parse (text), "my.json").body);
}

/** Two squares of four points each, of a plate with a corner missing. */
Json corner (const std::string& more)
{
    return Json::parse (
        R"({ "schema": "antinode.device/1", "name": "corner", "kind": "modal", "limits": { "voltage_V": 100 },
             "modes": [ { "frequency_Hz": 100, "damping_ratio": 0.01, "participation_per_V": [1], "shape": [1, 2, 3, 4] } ],
             "points_mm": [[10, 10], [50, 10], [10, 50], [30, 10]], "weights_kg": [0.1, 0.1, 0.1, 0.1],
             "outline": { "shape": "polygon", "vertices_mm": [[0, 0], [60, 0], [60, 20], [20, 20], [20, 60], [0, 60]] })"
        + more + "}");
}

std::string boundaryError (const Json& json)
{
    return errorText ([&] { readDevice (json, "my.json"); });
}
} // namespace

TEST_CASE ("A plate without an outline ends at the rectangle of its lengths, held where its edges are", "[documents]")
{
    Surface surface;
    surface.kind = SurfaceKind::plate;
    surface.xMaximum = 0.12;
    surface.yMinimum = -0.01;
    surface.yMaximum = 0.07;
    surface.held = { true, false, false, false };
    const auto boundary = boundaryOf (surface).value();
    CHECK (areaOf (boundary.outline) == Approx (0.12 * 0.08));
    REQUIRE (boundary.held.size() == 1);
    CHECK (boundary.held[0].start.x() == Approx (0).margin (1e-12));
    CHECK (boundary.held[0].end.x() == Approx (0).margin (1e-12));
    surface.kind = SurfaceKind::line;
    CHECK_FALSE (boundaryOf (surface));
}

TEST_CASE ("A surface keeps its outline, its held edge and its shapes through a modal device file", "[files][outlined]")
{
    const auto model = ring();
    const auto again = writtenAndRead (model);
    REQUIRE (again.surface.boundary);
    const auto& outline = again.surface.boundary->outline;
    REQUIRE (outline.paths.size() == 2);
    CHECK (areaOf (outline) == Approx (areaOf (model.surface.boundary->outline)).epsilon (1e-12));
    CHECK (again.surface.masses.sum() == Approx (model.surface.masses.sum()).epsilon (1e-12));
    CHECK (again.surface.xMaximum == Approx (0.06).epsilon (1e-12));

    // The hole's edge is held, whose pieces lie on a circle of 20 mm; the outer one is not.
    REQUIRE (again.surface.boundary->held.size() == model.surface.boundary->held.size());
    for (const auto& piece : again.surface.boundary->held)
        CHECK (piece.start.norm() == Approx (0.02));

    CHECK (again.ceramics[0].outline.paths.size() == 1);
    CHECK (again.ceramics[0].area == Approx (model.ceramics[0].area));
    const auto largest = model.shapes.cwiseAbs().maxCoeff();

    for (const auto& [x, y] :
         { std::pair { 0.05, 0.01 }, { -0.0595, 0.0 }, { 0.0, 0.0201 }, { 0.04, 0.002 }, { 0.03, -0.045 } })
        CHECK ((shapesAt (again, x, y) - shapesAt (model, x, y)).cwiseAbs().maxCoeff() < 5e-3 * largest);

    CHECK_THROWS_AS (shapesAt (again, 0.0, 0.0), InputError);
    CHECK_THROWS_AS (shapesAt (again, 0.055, 0.055), InputError);
}

TEST_CASE ("The outline of a modal device is checked like that of a plate", "[files][outlined]")
{
    const auto model = std::get<ModalModel> (readDevice (corner (R"(, "held_edges": ["1", "6"])"), "my.json").body);
    CHECK (model.surface.boundary->held.size() == 2);
    CHECK (model.surface.xMaximum == 0.06);
    CHECK_THROWS_AS (shapesAt (model, 0.04, 0.04), InputError);

    CHECK_THAT (boundaryError (corner (R"(, "held_edges": ["left"])")),
                Catch::StartsWith ("my.json: /held_edges/0") && Catch::Contains ("'left'") && Catch::Contains ("'6'"));

    auto outside = corner ("");
    outside["points_mm"][3] = { 40, 40 };
    CHECK_THAT (boundaryError (outside), Catch::StartsWith ("my.json: /outline") && Catch::Contains ("(40, 40) mm"));

    auto without = corner (R"(, "held_edges": ["1"])");
    without.erase ("outline");
    CHECK_THAT (boundaryError (without), Catch::StartsWith ("my.json: /held_edges"));

    auto line = corner ("");
    line["points_mm"] = { { 10, 10 }, { 20, 10 }, { 30, 10 }, { 40, 10 } };
    CHECK_THAT (boundaryError (line), Catch::Contains ("line"));
}
