#include <antinode_base/InputError.h>
#include <antinode_documents/DeviceFile.h>
#include <antinode_drafts/CeramicEdits.h>
#include <antinode_drafts/CeramicFaults.h>
#include <antinode_drafts/DeviceEdits.h>
#include <antinode_drafts/DeviceTemplates.h>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace antinode;

namespace
{
nlohmann::json drawnRectangle()
{
    return newDevice ("rectangle");
}

bool isDrawnCorrectly (const nlohmann::json& device)
{
    readDevice (device, "device");
    const auto faults = ceramicFaults (device);
    return std::none_of (faults.begin(), faults.end(), [] (const auto& fault) { return fault.isForbidden; });
}
} // namespace

TEST_CASE ("Every template and every drawn device of the library is right, and its edits are read", "[draft]")
{
    std::vector<nlohmann::json> devices;

    for (const auto& each : deviceTemplates())
        devices.push_back (newDevice (each.name));

    for (const auto& name : factoryNames (LibraryKind::device))
        devices.push_back (loadDocument (LibraryKind::device, name));

    for (const auto& device : devices)
    {
        INFO (device["name"]);
        CHECK (isDrawn (device));
        CHECK (isDrawnCorrectly (device));
        const auto size = sizeOf (device);
        CHECK (isDrawnCorrectly (withSize (device, 1.25 * size)));
        CHECK (sizeOf (withSize (device, 1.25 * size)).isApprox (1.25 * size, 1e-6));
        CHECK (withLayers (device, layersOf (device)) == device);
        CHECK (isDrawnCorrectly (withVoltageLimit (withQualityFactor (device, 20), 30)));

        for (const auto& edge : edgesOf (device))
        {
            CHECK (withSupport (device, edge.name, supportOf (device, edge.name)).dump() != "");
            const auto clamped = withSupport (device, edge.name, "clamped");
            CHECK (isDrawnCorrectly (clamped));
            CHECK (usualSupport (supportOf (clamped, edge.name))->name == "clamped");
        }

        // What is drawn is where it is said to be.
        auto same = device;

        for (std::size_t i = 0; i < ceramicsOf (device).size(); ++i)
            same = withCeramic (same, i, ceramicsOf (device)[i]);

        CHECK (isDrawnCorrectly (same));

        for (std::size_t i = 0; i < ceramicsOf (device).size(); ++i)
            CHECK (ceramicsOf (same)[i].centre.isApprox (ceramicsOf (device)[i].centre, 1e-6));
    }
}

TEST_CASE ("What the window cannot show stays in the document through every edit", "[draft]")
{
    auto device = drawnRectangle();
    device["description"] = "mine";
    device["foundation"] = { { "stiffness_N_per_mm3", 0.01 } };
    device["limits"]["requires_arming"] = true;
    device["ceramics"][0]["capacitance_nF"] = 7;
    device["ceramics"][0]["glue"] = "rigid";
    const auto mirrored = withMirrored (withoutCeramics (device, { 1 }), { 0 }, true);
    const auto edited = withPoint (
        withSupport (withLayers (withSize (withShifted (mirrored, { 0 }, { 0, 20 }), { 300, 200 }), { { "steel", 2 } }),
                     "left", "free"),
        0, { { 30, 40 }, 0, 5 });

    for (const auto* const key : { "description", "foundation", "limits" })
        CHECK (edited[key] == device[key]);

    CHECK (edited["ceramics"][0]["capacitance_nF"] == 7);
    CHECK (edited["ceramics"].back()["glue"] == "rigid"); // as the one that it mirrors
    CHECK (edited["ceramics"].back()["name"] == "C11");   // C10 is there
    readDevice (edited, "device");
}

TEST_CASE ("A wrong place of a ceramic is said: overlapping, outside, or close to an edge", "[draft]")
{
    auto device = drawnRectangle();
    const auto first = ceramicsOf (device).front();
    auto moved = first;
    moved.centre = ceramicsOf (device)[1].centre + Eigen::Vector2d (11, 0);
    auto faults = ceramicFaults (withCeramic (device, 0, moved));
    REQUIRE (faults.size() == 1);
    CHECK (faults.front().sentence == "C2 overlaps C1");
    CHECK (faults.front().isForbidden);

    // Their extents overlap, they do not.
    moved.centre = ceramicsOf (device)[1].centre + Eigen::Vector2d (9, 9);
    CHECK (ceramicFaults (withCeramic (device, 0, moved)).empty());

    moved.centre = { 3, 30 };
    faults = ceramicFaults (withCeramic (device, 0, moved));
    REQUIRE (faults.size() == 1);
    CHECK (faults.front().sentence == "C1 reaches outside");

    moved.centre = { 6.25, 50 };
    faults = ceramicFaults (withCeramic (device, 0, moved));
    REQUIRE (faults.size() == 1);
    CHECK (faults.front().sentence == "C1 is 0.25 mm from the edge");
    CHECK_FALSE (faults.front().isForbidden);
}

TEST_CASE ("Rows and rings lie evenly and free of faults", "[draft]")
{
    auto device = withSize (drawnRectangle(), { 180, 110 });
    CeramicChoice all;

    for (std::size_t i = 0; i < ceramicsOf (device).size(); ++i)
        all.insert (i);

    device = withoutCeramics (device, all);
    CHECK (ceramicsOf (device).empty());
    const DrawnCeramic disc { CeramicShape::disc, { 0, 0 }, { 15, 15 } };

    for (const auto side : { DeviceSide::bottom, DeviceSide::top })
        device = withRow (device, disc, 0, side, 5, 6);

    REQUIRE (ceramicsOf (device).size() == 10);
    CHECK (ceramicFaults (device).empty());
    CHECK (ceramicsOf (device)[0].centre.isApprox (Eigen::Vector2d (18, 13.5)));
    CHECK (ceramicsOf (device)[9].centre.isApprox (Eigen::Vector2d (162, 96.5)));
    CHECK (device["ceramics"][9]["name"] == "C10");
    const auto ring = withRing (newDevice ("disc"), { CeramicShape::disc, { 0, 0 }, { 10, 10 } }, 0, 6, 40);
    CHECK (ceramicFaults (ring).empty());
}
